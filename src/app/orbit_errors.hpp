// Error bars of a periodic state's figures, from the state with longer steps in space and time.
#pragma once

#include <optional>
#include <string>

#include "app/coarse_orbit.hpp"

namespace gearfilm {

/// The figure that is known worst, of those that have a limit in sight.
struct LargestError {
  std::string figure;
  double relative = 0.0;         ///< to its value; to the static force where a force is smaller, since it may vanish
  bool of_static_force = false;  ///< the latter

  /// "h_min has an error of about 12 %".
  std::string text() const;
};

/// Adds errors to the figures of an orbit's summary, and where they point to: `_error` and `_extrapolated`, null
/// without a coarser orbit; nothing is known then.
std::optional<LargestError> add_errors(const Scales& scales, const FoundOrbit& found, Summary& summary);

}  // namespace gearfilm

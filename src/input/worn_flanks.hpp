// What wear has made of the flanks of a case so far.
#pragma once

#include <array>
#include <vector>

#include "gear/monotone_cubic.hpp"

namespace gearfilm {

/// Curves at ascending places y across the face [m], an odd number with its middle in their middle; or none.
struct WornFlank {
  std::vector<double> y{};
  std::vector<FlankCurve> removed{};
};

struct WornFlanks {
  std::array<WornFlank, 2> flanks{};  ///< of pinion and wheel
  double roughness_ratio = 1.0;       ///< present roughness of both over that of the case
};

}  // namespace gearfilm

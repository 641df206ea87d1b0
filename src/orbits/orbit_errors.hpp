// Error bars of a periodic state's quantities, from the state with longer steps in space and time.
#pragma once

#include "numerics/estimate.hpp"
#include "orbits/coarse_orbit.hpp"

namespace gearfilm {

/// Finds the periodic state, and those on coarser grids that give its errors: of a pair on films of this
/// discretisation, or of the dry pair without one. Throws SolveError where none is found, and what the watch throws.
/// Collective.
FoundOrbit find_orbit_with_errors(const OrbitProblem& problem, const SharedDiscretisation& films,
                                  const SearchWatch& watch);

/// The error bar of one quantity.
struct OrbitError {
  std::string name;  ///< of the quantity: of a period, or transmission_error_peak_to_peak
  Unit unit;
  std::optional<Estimate> bar;  ///< dimensionless; nothing where nothing is known of it

  /// The estimate in the unit of summaries.
  std::optional<Estimate> in_si(const Scales& scales) const;
};

/// Errors of all quantities that depend on films, pressures or forces; none is known without a coarser orbit.
std::vector<OrbitError> errors_of(const FoundOrbit& found);

/// The quantity that is known worst, of those that have a limit in sight.
struct LargestError {
  std::string quantity;
  double relative = 0.0;        ///< to its value; to a scale where that is larger, since it may vanish
  std::string_view scale = {};  ///< the static force of forces, the roughness of films between rough surfaces

  /// "h_min has an error of about 12 %".
  std::string text() const;
};

/// Nothing where no error is known.
std::optional<LargestError> largest_of(const std::vector<OrbitError>& errors, const Scales& scales);

}  // namespace gearfilm

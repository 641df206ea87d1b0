// Where the search for the periodic state of a lubricated pair begins: with the dry pair's orbit, and where that leads
// to none, with states of the pair at speeds a little above and below. Beyond a speed at which two states meet and end,
// searches linger where these were; states that are found at other speeds lead past that.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "orbits/coarse_orbit.hpp"
#include "orbits/dry_sweep_point.hpp"

namespace gearfilm {

/// The state of the pair at another speed.
struct StateBeside {
  double speed_ratio = 1.0;  ///< over the speed of the pair whose state is sought
  Motion motion;             ///< where it begins, in the scales of that pair
  std::string why;           ///< why the search from the dry pair's orbit has failed
};

struct SearchesFromStarts {
  /// The search for the state: as the problem is, or from a state beside.
  std::function<FoundOrbit(const std::optional<StateBeside>& from)> own;
  /// The search at another speed. Both throw SolveError where nothing is found.
  std::function<DescribedOrbit(const OrbitProblem& beside)> beside;
};

/// The state from the first start that leads to one. A given start, and that of a drive train or of bodies in balance,
/// is the only one. at_speed: the problem by the speed over that of the pair. Throws NoPeriodicState
/// and what the searches throw. Collective.
FoundOrbit find_orbit_from_starts(const OrbitProblem& problem, const ProblemAt& at_speed,
                                  const SearchesFromStarts& searches);

/// The search at another speed, with the films of that problem's own grid; nothing of it is kept. Collective.
DescribedOrbit find_orbit_beside(MPI_Comm comm, const OrbitProblem& beside, const StopCheck& check_stop);

}  // namespace gearfilm

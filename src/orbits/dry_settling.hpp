// What the damped dry pair does when it is left to itself for long, and which periodic motions that points to.
//
//   x_n = (H_0, V_0) where the n-th pattern of teeth begins; the march ends where x_n comes to repeat (poincare.hpp)
// A motion that repeats, or settles, leads Newton's method to where it stays. One that does not passes near the
// unstable motions it moves about: where |x_(n+k) - x_n| is smallest one of order k is near, and a motion of doubled
// period has one midway between its two states.
#pragma once

#include <string>

#include "orbits/dry_shooting.hpp"
#include "orbits/poincare.hpp"

namespace gearfilm {

struct DrySettling {
  std::vector<PoincarePoint> points;  ///< motions only, one a pattern, the first after one
  int repeats_after = 0;              ///< patterns; 0: it does not repeat within 8
  int settles_on = 0;                 ///< the same of what it nears; 0: nothing
  Motion limit;                       ///< where that begins

  /// It comes to a motion of this order.
  bool leads_to(int order) const { return settles_on > 0 && order % settles_on == 0; }
};

/// Marched from a motion until it repeats, or a disturbance has died away three times over. Without a damping worth
/// the name (below 0.002) with that. Throws SolveError where the motion is not finite.
DrySettling settle_for_long(const DryMap& map, const Motion& from);

/// Where unstable motions of an order are to be sought, the likeliest first.
std::vector<Motion> near_unstable(const DrySettling& settling, int order);

/// What it does, for a message: "repeats after 2 mesh periods; try -periodic_order 2".
std::string what_it_does(const DrySettling& settling, const MeshModel& mesh);

}  // namespace gearfilm

// The periodic motion of the dry gear pair, by shooting.
//
// Unknown: (H_0, V_0) at the moment a contact has just left; equation: they repeat after one mesh period
// (dry_pair.hpp). Solved with SNES and a finite-difference Jacobian; a fraction of a second. The start of the
// lubricated orbit.
#pragma once

#include "gearfilm/dynamics/dry_pair.hpp"
#include "gearfilm/dynamics/monodromy.hpp"

namespace gearfilm {

struct DryOrbit {
  Motion start;  ///< where path.position begins
  Monodromy monodromy;
  double largest_integral = 0.0;  ///< largest pressure integral of one contact
};

/// path: starts (T = 0) just after a contact has left. Begins with a strongly damped pair, whose march finds its orbit
/// by itself, and lowers the damping to zero, each orbit starting from the last. Throws SolveError where no orbit is
/// found.
DryOrbit find_dry_orbit(const Scales& scales, const ContactPath& path, double inertia);

}  // namespace gearfilm

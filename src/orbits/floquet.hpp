// Floquet multipliers of a periodic orbit of the lubricated pair: eigenvalues of the map of the whole state (all
// pressures, q, v) over one mesh period, linearised.
//
// Matrix-free: the map is applied to a disturbance by marching one period from the disturbed state, and SLEPc's Arnoldi
// method needs a handful of such periods: 2 n for the multipliers of the motion from a disturbance that the
// films have followed. The search for the orbit leaves one; where it began too near for that, one more period makes
// one. Those of the films by themselves lie below the noise of the differences: the remaining Ritz values bound them
// from above.
#pragma once

#include <optional>

#include "orbits/periodic_orbit.hpp"

namespace gearfilm {

struct FloquetOptions {
  int periods = 2;           ///< marched; at least 2 n, and one more for a bound on the films' own
  double difference = 1e-3;  ///< size of a disturbance: of the motion, and of the pressures as a root mean square
};

struct FloquetMultipliers {
  Multipliers gear_pair;             ///< the 2 n largest
  std::optional<double> film_bound;  ///< largest modulus of the other Ritz values
};

/// The march goes on from the orbit's start, as often as the options say. Throws SolveError where a disturbed period
/// cannot be marched.
FloquetMultipliers floquet_multipliers(MeshMarch& march, const PeriodicOrbit& orbit, const FloquetOptions& options);

}  // namespace gearfilm

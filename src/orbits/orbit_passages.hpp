// The passages of contacts over the flanks in a periodic motion: one more period of it, marched from its beginning,
// with the stresses below its films.
#pragma once

#include "dynamics/flank_recorder.hpp"
#include "orbits/orbit_search.hpp"

namespace gearfilm {

/// One passage a tooth that differs from the others. Throws SolveError and Stopped. Collective.
std::vector<Passage> orbit_passages(const OrbitProblem& problem, const SharedDiscretisation& films,
                                    const PeriodicOrbit& orbit, const StopCheck& check_stop);

}  // namespace gearfilm

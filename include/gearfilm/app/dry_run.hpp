// The periodic motion of a case's dry pair, found and described as orbit_run does it for the lubricated pair.
#pragma once

#include "gearfilm/app/orbit_run.hpp"

namespace gearfilm {

/// Near a motion, where one is given: the orbit there, or what the pair settles on from there. The observer sees the
/// steps of one period. Throws SolveError where no orbit is found.
OrbitRun run_dry_orbit(const Case& problem, const MeshModel& mesh, const std::optional<Motion>& near,
                       const StepObserver& observer);

}  // namespace gearfilm

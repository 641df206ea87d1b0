// The periodic motion of a case's dry pair, found and described as orbit_run does it for the lubricated pair.
#pragma once

#include "app/orbit_run.hpp"
#include "gearfilm/orbits/dry_orbit.hpp"

namespace gearfilm {

/// zeta of the damper beside the contacts.
double dry_damping_ratio(const Case& problem);

/// Near a motion, where one is given: the orbit there, or what the pair settles on from there. The observer sees the
/// steps of one period. Throws SolveError where no orbit is found, and what the watch throws.
OrbitRun run_dry_orbit(const Case& problem, const MeshModel& mesh, const std::optional<Motion>& near,
                       const StepObserver& observer, const DryWatch& watch = {});

/// An orbit that was found, with its figures.
OrbitRun describe_dry_orbit(const Case& problem, const MeshModel& mesh, const DryOrbit& orbit,
                            const StepObserver& observer);

/// Ends a search where the run is to stop. Both must outlive the watch. Collective.
DryWatch stopping(MPI_Comm comm, const StopRequest& stop);

}  // namespace gearfilm

// Points of a sweep of the dry pair that failed, sought once more when all others are known: from the state that the
// other way has found at the same value, then from those at the values next to it, of both ways.
#pragma once

#include <vector>

#include "output/stop_request.hpp"
#include "output/sweep_points.hpp"

namespace gearfilm {

/// Over and over until no further one is found; each is written again, with a line on the screen. all: in the order of
/// the sweep. Throws Stopped. Collective.
void mend_sweep(MPI_Comm comm, const CaseInput& problem, const SweepPoints& points, const std::vector<SweepPoint>& all,
                const StopRequest& stop);

}  // namespace gearfilm

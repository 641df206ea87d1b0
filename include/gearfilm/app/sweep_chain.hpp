// The points of a sweep that follow one another: each periodic state from its neighbour's.
#pragma once

#include <vector>

#include "gearfilm/app/sweep_points.hpp"
#include "gearfilm/output/stop_request.hpp"

namespace gearfilm {

/// Points of one direction; a chain is the work of one group of processes.
using SweepChain = std::vector<SweepPoint>;

/// Computes the points that are still missing, writes each when it is done, and prints a line on it. A point without a
/// periodic state is recorded with its error, and the next one starts anew. Throws Stopped. Collective on the group.
void run_chain(MPI_Comm group, const Case& problem, const SweepPoints& points, const SweepChain& chain,
               const StopRequest& stop);

}  // namespace gearfilm

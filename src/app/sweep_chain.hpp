// The points of a sweep that follow one another: each periodic state from its neighbour's.
#pragma once

#include <vector>

#include "output/stop_request.hpp"
#include "output/sweep_points.hpp"

namespace gearfilm {

/// Points of one direction; a chain is the work of one group of processes.
using SweepChain = std::vector<SweepPoint>;

/// Computes the points that are still missing, writes each when it is done, and prints a line on it. A point without a
/// periodic state is recorded with its error; the next one starts again, one of the dry pair from the last that was
/// found. Throws Stopped. Collective on the group.
void run_chain(MPI_Comm group, const CaseInput& problem, const SweepPoints& points, const SweepChain& chain,
               const StopRequest& stop);

/// A line on a point that is done. Collective.
void print_point(MPI_Comm group, const CaseInput& problem, const Summary& point);

}  // namespace gearfilm

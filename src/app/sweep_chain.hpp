// The points of a sweep that follow one another: each periodic state from its neighbour's.
#pragma once

#include <vector>

#include "app/sweep_points.hpp"
#include "orbits/dry_sweep_point.hpp"
#include "output/stop_request.hpp"

namespace gearfilm {

/// Points of one direction; a chain is the work of one group of processes.
using SweepChain = std::vector<SweepPoint>;

/// Computes the points that are still missing, writes each when it is done, and prints a line on it. A point without a
/// periodic state is recorded with its error; the next one starts anew, one of the dry pair from the last that was
/// found. Throws Stopped. Collective on the group.
void run_chain(MPI_Comm group, const Case& problem, const SweepPoints& points, const SweepChain& chain,
               const StopRequest& stop);

/// The record of a point with its dry orbit. problem: of the point.
void add_dry_orbit(const OrbitProblem& problem, const DryPointFound& found, Summary& result);

/// A line on a point that is done. Collective.
void print_point(MPI_Comm group, const Case& problem, const Summary& point);

}  // namespace gearfilm

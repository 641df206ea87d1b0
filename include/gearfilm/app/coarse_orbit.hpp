// The periodic state on every second node with twice the time step: most of a search at an eighth of its cost, and what
// the error of the case's own grid and step is estimated from.
#pragma once

#include "gearfilm/app/orbit_run.hpp"

namespace gearfilm {

/// Where a search without a neighbour begins, and what it came from.
struct OrbitStart {
  OrbitGuess guess;
  std::optional<OrbitRun> coarse;  ///< absent where the grid has too few nodes for a coarser one, or that no films
  std::string trouble;             ///< why the coarser grid has none; empty where nothing went wrong
};

/// From the periodic state on the coarser grid, which is searched for from the dry pair's; where there is none, from
/// the dry pair's itself. The observers see nothing of the coarser grid's marches but its periods. Throws SolveError
/// where nothing repeats on it. Collective.
OrbitStart orbit_start(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                       const DryOrbit& dry, const OrbitObservers& observers);

/// Adds error bars to the figures of an orbit's summary, and where they point to: `_error` and `_extrapolated`, null
/// without a coarser orbit. Returns the largest relative one.
std::optional<double> add_errors(const Scales& scales, const OrbitRun& run, const std::optional<OrbitRun>& coarse,
                                 Summary& summary);

}  // namespace gearfilm

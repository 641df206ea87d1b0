// The stationary film of one contact under a prescribed force, from nothing.
//
// On a coarse grid from the dry (Hertz) pressure through pseudo-time (the squeeze term with a growing step), then
// grid by grid with the coarser film as first guess; pseudo-time again wherever Newton alone fails.
#pragma once

#include <vector>

#include "gearfilm/ehl/stationary_newton.hpp"

namespace gearfilm {

struct StationaryResult {
  FilmSolution solution;
  FilmFigures figures;
  SolveCounts counts;                 ///< on the finest grid
  std::vector<SolveCounts> by_grid;   ///< coarsest first, the finest last
};

/// Film on film.grid() under the force integral F, from nothing. Throws SolveError naming the step that failed.
StationaryResult solve_stationary(ContactFilm& film, double force, const SolverOptions& options);

}  // namespace gearfilm

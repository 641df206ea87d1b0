// The stationary film of one contact under a prescribed force, or at a prescribed displacement.
//
// From nothing: on a coarse grid from the dry (Hertz) pressure, then grid by grid with the coarser film as first guess,
// and from the dry pressure where that fails. Where Newton's method alone does not lead from a guess to the film,
// through pseudo-time (the squeeze term with a growing step).
#pragma once

#include <optional>
#include <vector>

#include "solver/stationary_newton.hpp"

namespace gearfilm {

struct StationaryResult {
  FilmSolution solution;
  FilmQuantities quantities;
  SolveCounts counts;                    ///< on the finest grid
  std::vector<SolveCounts> by_grid;      ///< coarsest first, the finest last
  std::optional<FilmQuantities> before;  ///< on the grid before the finest, where the film was found from there
};

/// Film on film.grid() under the load condition, from nothing. Throws SolveError naming the step that failed.
StationaryResult solve_stationary(ContactFilm& film, const LoadCondition& load, const SolverOptions& options);

/// Solves from a film that is near, on its own grid; from nothing where that fails.
StationaryResult continue_stationary(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                     const FilmSolution& guess);

/// Solves by Newton's method alone from a film that is near; returns nothing where that fails.
std::optional<StationaryResult> improve_stationary(ContactFilm& film, const LoadCondition& load,
                                                   const SolverOptions& options, const FilmSolution& guess);

/// Several films under one condition, from films that are near, on their own grid. Throws SolveError.
FilmSolution solve_together(const std::vector<ContactFilm*>& films, const LoadCondition& load,
                            const SolverOptions& options, FilmSolution guess);

}  // namespace gearfilm

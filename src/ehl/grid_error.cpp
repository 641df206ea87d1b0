#include "gearfilm/ehl/grid_error.hpp"

#include "gearfilm/ehl/transfer.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/parallel/events.hpp"

namespace gearfilm {
namespace {

FilmSolution on_coarser(const Grid& grid, const Grid& coarse_grid, const FilmSolution& solution) {
  Field<double> fine(grid), coarse(coarse_grid);
  fine.load(solution.pressure);
  inject(grid, coarse_grid, fine, coarse);
  FilmSolution found{std::vector<double>(coarse_grid.local_size()), solution.H0};
  coarse.store(found.pressure);
  return found;
}

std::optional<GridErrors> errors_between(const FilmFigures& fine, const FilmFigures& half) {
  if (!half.finite || half.smallest_film <= 0.0) return {};
  return GridErrors{estimate(fine.central_film, half.central_film), estimate(fine.smallest_film, half.smallest_film),
                    estimate(fine.central_pressure, half.central_pressure),
                    estimate(fine.largest_pressure, half.largest_pressure)};
}

}  // namespace

std::optional<GridErrors> grid_errors(const ContactFilm& film, const SolverOptions& options,
                                      const StationaryResult& result, const CoarseSolver& solve) {
  const ScopedStage stage("Error of the grid");
  const Discretisation* coarser = film.discretisation()->coarser();
  if (!coarser) return {};
  ContactFilm coarse(SharedDiscretisation(film.discretisation(), coarser), film.scales(), options.multigrid);
  coarse.set_conditions(film.conditions());
  StationaryResult found;
  try {
    found = solve(coarse, on_coarser(film.grid(), coarser->grid(), result.solution));
  } catch (const SolveError&) {
    return {};
  }
  return errors_between(result.figures, found.figures);
}

std::optional<GridErrors> grid_errors(const ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                      const StationaryResult& result) {
  const Discretisation& fine = *film.discretisation();
  if (result.before && fine.before() == fine.coarser()) return errors_between(result.figures, *result.before);
  return grid_errors(film, options, result, [&](ContactFilm& coarse, const FilmSolution& guess) {
    // From nothing, grid by grid: where the fine film ends between two nodes, Newton's method has a longer way from it.
    try {
      return solve_stationary(coarse, load, options);
    } catch (const SolveError&) {
      return continue_stationary(coarse, load, options, guess);
    }
  });
}

}  // namespace gearfilm

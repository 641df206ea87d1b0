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
  const FilmFigures &fine = result.figures, &half = found.figures;
  if (!half.finite || half.smallest_film <= 0.0) return {};
  return GridErrors{estimate(fine.central_film, half.central_film), estimate(fine.smallest_film, half.smallest_film),
                    estimate(fine.central_pressure, half.central_pressure),
                    estimate(fine.largest_pressure, half.largest_pressure)};
}

std::optional<GridErrors> grid_errors(const ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                      const StationaryResult& result) {
  return grid_errors(film, options, result, [&](ContactFilm& coarse, const FilmSolution& guess) {
    return continue_stationary(coarse, load, options, guess);
  });
}

}  // namespace gearfilm

#include "solver/grid_error.hpp"

#include <algorithm>

#include "film/expected_errors.hpp"
#include "film/face_quantities.hpp"
#include "film/transfer.hpp"
#include "gearfilm/error.hpp"
#include "parallel/events.hpp"

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

/// Of a film between rough surfaces, which may be thin against sigma and negative: relative to sigma at least.
Estimate of_rough_film(double fine, double half, double least_bar, double sigma) {
  Estimate film = estimate_fast(fine, half, 0.0);
  film.least = sigma;
  film.error = std::max(film.error, least_bar * std::max(std::abs(fine), sigma));
  return film;
}

std::optional<GridErrors> errors_between(const Discretisation& discretisation, const Scales& scales,
                                         const FilmQuantities& fine, const FilmQuantities& half) {
  const RoughSurfaces* rough = scales.solids.rough.get();
  if (!half.finite || (!rough && half.smallest_film <= 0.0)) return {};
  const double step = discretisation.grid().h_x();
  const bool fitted = discretisation.of_films() == FilmDiscretisation::fitted;
  const double spike = fine.spike_pressure, half_spike = half.spike_pressure;
  GridErrors errors{fitted ? estimate_fast(fine.central_film, half.central_film, least_bars.central)
                           : estimate(fine.central_film, half.central_film),
                    fitted ? estimate_fast(fine.smallest_film, half.smallest_film, least_bars.smallest)
                           : estimate_smallest(fine.smallest_film, half.smallest_film),
                    estimate_beside_spike({fine.central_pressure, spike}, {half.central_pressure, half_spike}, step),
                    estimate_largest({fine.largest_pressure, spike}, {half.largest_pressure, half_spike}, step),
                    estimate_spike(spike, half_spike)};
  if (rough) {
    const double sigma = rough->sigma() / scales.thickness;
    errors.central_film = of_rough_film(fine.central_film, half.central_film, least_bars.central, sigma);
    errors.smallest_film = of_rough_film(fine.smallest_film, half.smallest_film, least_bars.smallest, sigma);
  }
  return errors;
}

/// Coarser grids over a face have the same rows, and tell nothing of them.
void add_rows_of_face(const ContactFilm& film, Estimate& smallest_film) {
  smallest_film.error = std::max(smallest_film.error, face_quantities(film).film_between_rows());
}

/// From nothing, grid by grid; where a step of that way fails, from the finer film. That alone would take far longer:
/// 19 Newton iterations from 1025 x 1025 nodes, five times the work.
StationaryResult film_on_coarser(const ContactFilm& film, ContactFilm& coarse, const LoadCondition& load,
                                 const SolverOptions& options, const FilmSolution& finer) {
  try {
    return solve_stationary(coarse, load, options);
  } catch (const SolveError&) {
    return continue_stationary(coarse, load, options, on_coarser(film.grid(), coarse.grid(), finer));
  }
}

}  // namespace

std::optional<GridErrors> grid_errors(const ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                      const StationaryResult& result, const CoarseCoupling& couple) {
  const ScopedStage stage("Error of the grid");
  Discretisation& fine = *film.discretisation();
  const auto against = [&](Discretisation* coarser) -> std::optional<GridErrors> {
    if (!coarser) return {};
    if (!couple && result.before && fine.prepare_sequencing_grid() == coarser)
      return errors_between(fine, film.scales(), result.quantities, *result.before);
    ContactFilm coarse(SharedDiscretisation(film.discretisation(), coarser), film.scales(), options.multigrid);
    coarse.set_surfaces(injected_surfaces(film.grid(), coarse.grid(), film.surfaces()));
    try {
      const StationaryResult alone = film_on_coarser(film, coarse, load, options, result.solution);
      return errors_between(fine, film.scales(), result.quantities,
                            couple ? couple(coarse, alone).quantities : alone.quantities);
    } catch (const SolveError&) {
      return {};
    }
  };
  std::optional<GridErrors> errors = against(fine.prepare_coarser());
  // Fitted films have few rows, of which half may not be enough; most of their errors come from the lines.
  if (!errors && fine.of_films() == FilmDiscretisation::fitted)
    errors = against(fine.prepare_coarser(Coarsening::x_only));
  if (errors && film.scales().solids.face) add_rows_of_face(film, errors->smallest_film);
  return errors;
}

}  // namespace gearfilm

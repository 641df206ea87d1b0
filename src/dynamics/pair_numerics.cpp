#include "dynamics/pair_numerics.hpp"

#include <cmath>
#include <numbers>

#include "film/validity.hpp"

namespace gearfilm {

GridShape grid_shape(const PairNumerics& numerics, const Scales& scales) {
  const Domain& domain = numerics.domain;
  if (scales.solids.line) return {numerics.nx, domain.x_min, domain.x_max, RowAxis::line()};
  if (numerics.face_rows) {
    return {numerics.nx, domain.x_min, domain.x_max,
            rows_over_face(*scales.solids.face, *numerics.face_rows, scales.length)};
  }
  return grid_shape(numerics.domain, scales.hertz.ellipticity, numerics.nx, numerics.ny);
}

SharedDiscretisation discretise(MPI_Comm comm, const PairNumerics& numerics, const Scales& scales) {
  return discretise(Grid(comm, grid_shape(numerics, scales)), numerics, scales);
}

SharedDiscretisation discretise(const Grid& grid, const PairNumerics& numerics, const Scales& scales) {
  return discretise(grid, scales, numerics.discretisation);
}

Steps steps_of(const PairNumerics& numerics) {
  const Domain& domain = numerics.domain;
  const bool equal_rows = numerics.ny > 1 && !numerics.face_rows;
  return {(domain.x_max - domain.x_min) / (numerics.nx - 1),
          equal_rows ? 2.0 * domain.y_half / (numerics.ny - 1) : 0.0};
}

std::optional<PairNumerics> coarser(const PairNumerics& numerics) {
  constexpr int fewest_x = 33, fewest_y = 9;
  PairNumerics coarse = numerics;
  coarse.nx = (numerics.nx - 1) / 2 + 1;
  if (coarsened_along(numerics) == Coarsening::both) coarse.ny = (numerics.ny - 1) / 2 + 1;
  coarse.steps.lengthen(2.0);
  return coarse.nx >= fewest_x && coarse.ny >= fewest_y ? std::optional(coarse) : std::nullopt;
}

Coarsening coarsened_along(const PairNumerics& numerics) {
  return numerics.face_rows ? Coarsening::x_only : Coarsening::both;
}

SlightlyCoarser slightly_coarser(const PairNumerics& numerics) {
  constexpr int block = 8;  // of cells, so that there are coarser grids
  const auto fewer = [](int nodes) {
    return block * static_cast<int>(std::lround((nodes - 1) / (block * std::numbers::sqrt2))) + 1;
  };
  PairNumerics coarse = numerics;
  coarse.nx = fewer(numerics.nx);
  if (!coarse.face_rows) coarse.ny = fewer(numerics.ny);
  const double ratio = (numerics.nx - 1.0) / (coarse.nx - 1.0);
  if (coarse.face_rows) coarse.face_rows->lengthen(ratio);
  coarse.steps.lengthen(ratio);
  return {coarse, ratio};
}

MeshMarch make_march(const MeshModel& mesh, const PairNumerics& numerics, const SharedDiscretisation& films,
                     StepObserver observer, RunStore* store) {
  MarchOptions options{numerics.solver, numerics.steps, numerics.margins, numerics.on_widening};
  options.films.multigrid.keep_rows = false;
  options.films.multigrid.levels =
      numerics.step_levels > 0 ? numerics.step_levels : step_levels(films->grid(), numerics.steps.dT);
  return MeshMarch(films, mesh, options, std::move(observer), store);
}

StationaryResult pitch_film(const Scales& scales, const PairNumerics& numerics, const SharedDiscretisation& films,
                            const FilmSolution* guess) {
  ContactFilm film(films, scales, numerics.solver.multigrid);
  const LoadCondition load = LoadCondition::force(scales.static_force);
  return located("contact at the pitch point", [&] {
    return guess ? continue_stationary(film, load, numerics.solver, *guess)
                 : solve_stationary(film, load, numerics.solver);
  });
}

}  // namespace gearfilm

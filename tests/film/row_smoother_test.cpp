// Relaxation of whole rows, and the linearised film on graded rows.
#include "film/row_smoother.hpp"

#include <algorithm>
#include <memory>
#include <tuple>

#include "face_case.hpp"
#include "film/face_pressure.hpp"
#include "placed_film.hpp"

namespace gearfilm {
namespace {

/// A film linearised about a dry pressure, in double precision, at this smallest film.
struct LinearFilm {
  LinearFilm(MPI_Comm comm, const Scales& scales, const GridShape& shape, double step_shift = 5.0,
             double smallest_film = 0.2)
      : shift(step_shift),
        grid(comm, shape),
        film(discretise(grid, scales), scales, {.precision = Precision::double_precision}) {
    std::vector<double> pressure(grid.local_size());
    face_pressure(*film.discretisation(), scales, film.conditions(), scales.static_force, pressure);
    const double H0 = smallest_film - film.quantities(pressure, 0.0).smallest_film;
    film.linearise(pressure, H0, {}, shift);
    full.resize(pressure.size());
    film.state().full_film.store(full);
  }

  /// Inner nodes that are not full, of the process that has most.
  double cavitated() const {
    const RowRange rows = grid.inner_rows();
    return maximum((grid.nx() - 2.0) * rows.count() - static_cast<double>(std::ranges::count(full, 1.0)));
  }

  /// The film on its graded rows, as relaxation sees it.
  FilmStencil<double> stencil() {
    FilmStencil<double> linear(grid);
    linearise(film.discretisation()->equation(), shift, film.state(), linear);
    return linear;
  }

  std::unique_ptr<RowSmoother<double>> smoother() {
    Discretisation& discretisation = *film.discretisation();
    auto smoother = std::make_unique<RowSmoother<double>>(grid, discretisation.halo(),
                                                          discretisation.prepare_deformation<double>());
    smoother->factor(stencil(), film.state(), shift, SmootherFactors::of_this_state);
    return smoother;
  }

  double shift;  ///< of a time step, so that it cannot be forgotten
  Grid grid;
  ContactFilm film;
  std::vector<double> full;  ///< 1 where Reynolds' equation holds
};

// The rows beside it have no changes, and its cavitated nodes none: what is left of its own is round-off of its matrix,
// and what oil in the inlet changes farther away, of which there is nothing where time steps are so short that it
// matters everywhere.
TEST(RowSmoother, solves_a_row_whose_neighbours_stand_still) {
  const Scales scales = face_scales(face_with(EndFace::free, relieved_ends()));
  for (const auto& [lower, shift, tolerance] : {std::tuple{Edge::symmetry, 1e8, 1e-10},
                                                {Edge::ambient, 1e8, 1e-10},
                                                {Edge::symmetry, 5.0, 5e-3},
                                                {Edge::ambient, 5.0, 5e-3}}) {
    const RowAxis rows = rows_of_face(scales, few_rows, lower);
    LinearFilm linear(PETSC_COMM_WORLD, scales, shape_over(rows, 33), shift);
    const Grid& grid = linear.grid;
    const std::unique_ptr<RowSmoother<double>> smoother = linear.smoother();
    Field<double> residual(grid), relaxed(grid);
    for (const int row : {lower == Edge::symmetry ? 0 : 1, rows.count() / 2, rows.count() - 2}) {
      std::vector<double> right(grid.local_size(), 0.0), change(right), product(right);
      const int j = grid.local_row(row);
      for (int i = 0; j >= 0 && i < grid.nx(); ++i) {
        const int n = i * grid.y_count() + j;
        right[n] = linear.full[n] * noise(i, row);
      }
      residual.load(right);
      smoother->solve_rows(residual, relaxed);
      relaxed.store(change);
      linear.film.multiply(change, 0.0, product);
      double off = 0.0, elsewhere = 0.0;
      for (int n = 0; n < grid.local_size(); ++n) {
        if (n % grid.y_count() == j) {
          off = std::max(off, std::abs(product[n] - right[n]));
        } else {
          elsewhere = std::max(elsewhere, std::abs(change[n]));
        }
      }
      EXPECT_LT(maximum(off), tolerance) << row;
      EXPECT_EQ(maximum(elsewhere), 0.0) << row;
    }
  }
}

// A cavitated row is d v = r, known at once.
TEST(RowSmoother, solves_cavitated_rows) {
  const Scales scales = face_scales(face_with(EndFace::half_space, relieved_ends()));
  LinearFilm linear(PETSC_COMM_WORLD, scales, shape_over(rows_of_face(scales, few_rows, Edge::symmetry), 65));
  const Grid& grid = linear.grid;
  std::vector<double> right(grid.local_size(), 0.0), change(right), product(right);
  for (int i = 1; i < grid.nx() - 1; ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      if (!grid.is_boundary(i, j)) right[i * grid.y_count() + j] = noise(i, grid.y_begin() + j);
    }
  }
  linear.film.relax(right, change);
  linear.film.multiply(change, 0.0, product);
  double off = 0.0;
  for (std::size_t n = 0; n < right.size(); ++n) {
    if (linear.full[n] == 0.0) off = std::max(off, std::abs(product[n] - right[n]));
  }
  EXPECT_LT(maximum(off), 1e-13);
  EXPECT_GT(linear.cavitated(), 10.0);
}

// What the changes of rows conduct into one another is taken up but for a part, and all of the residual of nodes that
// were left out of them.
TEST(FlowBetweenRows, is_taken_up) {
  const Scales scales = face_scales(face_with(EndFace::free, relieved_ends()));
  for (const Edge lower : {Edge::symmetry, Edge::ambient}) {
    LinearFilm linear(PETSC_COMM_WORLD, scales, shape_over(rows_of_face(scales, few_rows, lower), 65));
    const Grid& grid = linear.grid;
    const FilmStencil<double> stencil = linear.stencil();
    const Halo& halo = linear.film.discretisation()->halo();
    const Field<double> no_film(grid);
    Field<double> along(grid), left_out(grid), residual(grid);
    for (int i = 1; i < grid.nx() - 1; ++i) {
      for (int j = grid.inner_rows().begin; j < grid.inner_rows().end; ++j) {
        const int row = grid.y_begin() + j;
        left_out.row(i)[j] = noise(row, i) > 0.4 ? 1.0 : 0.0;
        residual.row(i)[j] = noise(i, 2 * row);
        along.row(i)[j] = (1.0 - left_out.row(i)[j]) * noise(i, row);
      }
    }
    Field<double> change = along;
    FlowBetweenRows<double> flow(grid, halo);
    flow.factor(stencil, left_out);
    flow.correct(residual, change);
    const auto conducted = [&](Field<double>& of, bool across) {
      FilmStencil<double> conduction = stencil;
      for (const Neighbour side : {south, north}) {
        if (!across) conduction.by_pressure[side].fill(0.0);
      }
      halo.exchange(of);
      Field<double> rows(grid);
      apply_stencil(conduction, of, no_film, rows);
      return rows;
    };
    const Field<double> own = conducted(along, false), uncorrected = conducted(along, true),
                        corrected = conducted(change, true);
    double left = 0.0, before = 0.0;
    for (int i = 1; i < grid.nx() - 1; ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        const double wanted = left_out.row(i)[j] != 0.0 ? residual.row(i)[j] : own.row(i)[j];
        left = std::max(left, std::abs(corrected.row(i)[j] - wanted));
        before = std::max(before, std::abs(uncorrected.row(i)[j] - wanted));
      }
    }
    report("%.2g of the flow is left", maximum(left) / maximum(before));
    EXPECT_LT(maximum(left), 0.05 * maximum(before));
  }
}

// The preconditioner of a single row is one relaxation.
TEST(RowSmoother, of_a_line_contact_is_the_inverse) {
  LinearFilm linear(PETSC_COMM_SELF, line_scales(face_load / face_width), shape_over(RowAxis::line(), 129));
  EXPECT_GT(linear.cavitated(), 5.0);
  std::vector<double> right(linear.full), change(right.size()), product(right.size());
  for (std::size_t n = 0; n < right.size(); ++n) right[n] *= noise(static_cast<int>(n), 0);
  linear.film.precondition(right, change);
  linear.film.multiply(change, 0.0, product);
  double off = 0.0;
  for (std::size_t n = 0; n < right.size(); ++n) {
    if (linear.full[n] != 0.0) off = std::max(off, std::abs(product[n] - right[n]));
  }
  EXPECT_LT(off, 1e-10);
}

// Where the film's edge has moved on by a node in every third row since the factors were made: the nodes that it has
// reached are relaxed nearly as with new factors. By their diagonals alone they would hardly change, and those about
// them not at all.
TEST(RowSmoother, takes_up_nodes_that_filled_since_its_factors_were_made) {
  const Scales scales = face_scales(face_with(EndFace::free, relieved_ends()));
  LinearFilm linear(PETSC_COMM_SELF, scales, shape_over(rows_of_face(scales, few_rows, Edge::ambient), 65), 5.0, 1.0);
  const Grid& grid = linear.grid;
  const std::unique_ptr<RowSmoother<double>> anew = linear.smoother(), kept = linear.smoother();
  FilmState earlier = linear.film.state();
  Field<double> residual(grid);
  for (int j = grid.inner_rows().begin; j < grid.inner_rows().end; ++j) {
    const int row = grid.y_begin() + j;
    int edge = grid.nx() - 2;
    while (edge > 0 && earlier.full_film.row(edge)[j] == 0.0) --edge;
    if (row % 3 != 0 || edge == 0 || edge == grid.nx() - 2) continue;
    earlier.full_film.row(edge)[j] = 0.0;
    residual.row(edge)[j] = 1.0 + noise(row, 1);
  }
  FilmStencil<double> stencil(grid);
  linearise(linear.film.discretisation()->equation(), linear.shift, earlier, stencil);
  kept->factor(stencil, earlier, linear.shift, SmootherFactors::of_this_state);
  kept->factor(linear.stencil(), linear.film.state(), linear.shift, SmootherFactors::of_earlier_states_too);
  Field<double> by_new_factors(grid), by_kept_factors(grid), right = residual;
  anew->relax(right, by_new_factors);
  kept->relax(residual, by_kept_factors);
  double change = 0.0, off = 0.0;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      change = std::max(change, std::abs(by_new_factors.row(i)[j]));
      off = std::max(off, std::abs(by_kept_factors.row(i)[j] - by_new_factors.row(i)[j]));
    }
  }
  report("off by %.2g of the change", maximum(off) / maximum(change));
  EXPECT_GT(maximum(off), 0.0);
  EXPECT_LT(maximum(off), 0.2 * maximum(change));
}

// One solve a Newton iteration, to 1 %: 7 to 10 where rows are not corrected for one another.
TEST(RowSmoother, leaves_few_krylov_iterations) {
  const Scales scales = face_scales(face_with(EndFace::half_space, relieved_ends()));
  const SolvedFilm solved(PETSC_COMM_WORLD, scales, shape_over(rows_of_face(scales, {}, Edge::symmetry), 129));
  const SolveCounts& counts = solved.result.counts;
  report("%d rows: %d Newton iterations, %.1f Krylov iterations each", solved.grid.ny(), counts.newton,
         counts.krylov / static_cast<double>(counts.newton));
  EXPECT_LE(counts.krylov, 7.0 * counts.newton);
  EXPECT_LE(counts.newton, 20);
}

/// Inner nodes without pressure, of the process that has most.
double cavitated(const Grid& grid, const std::vector<double>& pressure) {
  int nodes = 0;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j)
      nodes += !grid.is_boundary(i, j) && pressure[i * grid.y_count() + j] == 0.0;
  }
  return maximum(nodes);
}

// Misaligned, so that neither end is like the other.
TEST(FaceJacobian, is_the_slope_of_the_residual_on_graded_rows_with_free_ends) {
  const FaceGap gap = {.slope = 5e-6 / face_width, .reliefs = relieved_ends().reliefs};
  const Scales scales = face_scales(face_with(EndFace::free, gap));
  const GridShape shape = shape_over(rows_of_face(scales, few_rows, Edge::ambient), 65);
  for (const auto by : {FilmDiscretisation::fitted, FilmDiscretisation::central}) {
    const SolvedFilm at(PETSC_COMM_WORLD, scales, shape, {}, by);
    EXPECT_GT(cavitated(at.grid, at.result.solution.pressure), 10.0);
    expect_second_order(at.film, at.result.solution);
    expect_second_order(at.film, at.result.solution, 1e-2);
  }
}

}  // namespace
}  // namespace gearfilm

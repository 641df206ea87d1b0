// The parts of the preconditioner put together by hand must be the preconditioner.
#include "film/multigrid_level.hpp"
#include "film_case.hpp"
#include "film/linearised_film.hpp"

namespace gearfilm {
namespace {

class Multigrid : public testing::Test {
protected:
  Multigrid() {
    // A film with cavitated nodes need not be converged for this.
    const FilmSolution solution = film_away_from_pitch(65, 33);
    ContactFilm film(discretisation, pitch.scales, MultigridOptions{});
    move_surfaces(film, away_from_pitch());
    std::vector<double> rows(grid.local_size());
    film.evaluate(own_part(grid, solution.pressure), solution.H0);
    state.total_pressure = film.total_pressure();
    state.thickness = film.thickness();
    FilmProperties(pitch.scales).evaluate(state);
    exchange_ghosts(Halo(grid), state);
    state.entrained.fill(entrainment);
    reynolds_residual(discretisation->equation(), in_all_rows(grid, entrainment), state, {}, rows);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (!grid.is_boundary(i, j)) right_side[i * grid.y_count() + j] = noise(i, grid.y_begin() + j);
      }
    }
    fine.update(state, shift);
    const Discretisation& coarser = coarse.discretisation();
    coarse.update(injected_state(grid, coarser.grid(), coarser.halo(), state), shift);
  }

  /// The preconditioner's answer to the right side.
  std::vector<double> preconditioned(const MultigridOptions& options) {
    const auto preconditioner = make_linearised_film(*discretisation, options);
    preconditioner->update(state, shift);
    std::vector<double> change(grid.local_size());
    preconditioner->apply(right_side, change);
    return change;
  }

  void expect_same(const std::vector<double>& computed, const std::vector<double>& expected) {
    // The same operations; a sum or two in another order.
    EXPECT_LT(relative_difference(whole_of(grid, computed), whole_of(grid, expected)), 1e-12);
  }

  static constexpr double shift = 5.0;
  const double entrainment = away_from_pitch().entrainment;
  FilmCase pitch = table3_pitch();
  const SharedDiscretisation discretisation = discretise(Grid(PETSC_COMM_WORLD, pitch.shape(65, 33)), pitch.scales);
  const Grid& grid = discretisation->grid();
  FilmState state{grid};
  MultigridLevel<double> fine{*discretisation};
  MultigridLevel<double> coarse{*discretisation->prepare_coarser(Coarsening::x_only)};  // its cells are long
  std::vector<double> right_side = std::vector<double>(grid.local_size(), 0.0);
};

TEST_F(Multigrid, one_level_is_the_smoother) {
  std::vector<double> expected(grid.local_size());
  fine.smooth(right_side, expected, 3, true);
  expect_same(preconditioned({.levels = 1, .smoothing_sweeps = 3, .precision = Precision::double_precision}), expected);
}

TEST_F(Multigrid, two_levels_are_the_cycle_put_together_by_hand) {
  std::vector<double> change(grid.local_size()), rows(grid.local_size());
  std::vector<double> coarse_residual(coarse.grid().local_size()), correction(coarse.grid().local_size());
  fine.smooth(right_side, change, 2, true);
  fine.multiply(change, rows);
  for (std::size_t n = 0; n < rows.size(); ++n) rows[n] = right_side[n] - rows[n];
  coarse.restrict_from(fine, rows, coarse_residual);
  coarse.smooth(coarse_residual, correction, 5, true);
  coarse.interpolate_to(fine, correction, change);
  fine.smooth(right_side, change, 2, false);
  expect_same(preconditioned(
                  {.levels = 2, .smoothing_sweeps = 2, .coarse_sweeps = 5, .precision = Precision::double_precision}),
              change);
}

// The finest level's operator is the Jacobian itself.
TEST_F(Multigrid, finest_operator_is_the_jacobian) {
  const FilmSolution solution = film_away_from_pitch(65, 33);
  ContactFilm film(discretisation, pitch.scales, MultigridOptions{.precision = Precision::double_precision});
  move_surfaces(film, away_from_pitch());
  std::vector<double> rows(grid.local_size()), expected(grid.local_size());
  film.linearise(own_part(grid, solution.pressure), solution.H0, {}, shift);
  film.multiply(right_side, 0.0, expected);
  fine.multiply(right_side, rows);
  expect_same(rows, expected);
}

}  // namespace
}  // namespace gearfilm

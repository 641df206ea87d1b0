// The linearised Reynolds equation, row by row, against differences of its residual, without any deformation.
#include "film/film_stencil.hpp"

#include "film/face_flow.hpp"
#include "film_case.hpp"

namespace gearfilm {
namespace {

class LinearFilmRows : public testing::TestWithParam<FilmDiscretisation> {
protected:
  // Conductances of order one, so that wedge, squeeze and Poiseuille terms weigh alike in every row.
  static Scales scales() {
    Scales scales = circular_contact().scales;
    scales.lambda = 0.5;
    return scales;
  }

  /// P and H at x + e (v, u).
  void set_state(double step) {
    fill(grid, state.total_pressure,
         [](double x, double y) { return 0.3 + 0.1 * std::sin(2.0 * x + 0.3) * std::cos(y); });
    fill(grid, state.thickness,
         [](double x, double y) { return 1.0 + 0.2 * std::cos(3.0 * x) * std::sin(2.0 * y + 1.0); });
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        state.total_pressure.row(i)[j] += step * v.row(i)[j];
        state.thickness.row(i)[j] += step * u.row(i)[j];
      }
    }
    FilmProperties(scales()).evaluate(state);
    exchange_ghosts(halo, state);
  }

  /// R with the squeeze term shift rho H and what changes from node to node; a constant of -1e4 keeps every inner node
  /// full.
  std::vector<double> residual_at(double step, double shift) {
    set_state(step);
    std::vector<double> rate(grid.local_size()), residual(grid.local_size());
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        rate[i * grid.y_count() + j] =
            shift * state.density.row(i)[j] * state.thickness.row(i)[j] + 10.0 * noise(i, grid.y_begin() + j, 9) - 1e4;
      }
    }
    reynolds_residual(equation, U, state, {rate}, residual);
    return residual;
  }

  LinearFilmRows() {
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        v.row(i)[j] = noise(i, grid.y_begin() + j, 7);
        u.row(i)[j] = noise(i, grid.y_begin() + j, 8);
      }
    }
    halo.exchange(v);
    halo.exchange(u);
    state.entrained.fill(entrainment);
    state.of_rates = rates_in_wedge(0.2);
  }

  static constexpr double entrainment = 1.1;
  Grid grid{PETSC_COMM_WORLD, rectangle(17, 13, -1.5, 1.0, 1.2)};
  Halo halo{grid};
  FilmState state{grid};
  ReynoldsEquation equation{grid, scales().C_h, GetParam()};
  const std::vector<double> U = in_all_rows(grid, entrainment);
  Field<double> v{grid}, u{grid}, rows{grid};
  FilmStencil<double> linear{grid};
};

TEST_P(LinearFilmRows, full_rows_are_the_derivative_of_the_residual) {
  for (const double shift : {0.0, 3.0}) {
    // Central differences: off by e^2/6 times third derivatives of order (alpha_B p_h)^3 ~ 1e3, and by round-off/e of
    // the constant 1e4: both 1e-6.
    constexpr double step = 1e-5, tolerance = 1e-5;
    const auto more = residual_at(step, shift), less = residual_at(-step, shift);
    (void)residual_at(0.0, shift);
    linearise(equation, shift, state, linear);
    apply_stencil(linear, v, u, rows);
    double top = 0.0;
    for (int i = 1; i < grid.nx() - 1; ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (grid.is_boundary(i, j)) continue;
        const int n = i * grid.y_count() + j;
        EXPECT_NEAR(rows.row(i)[j], (more[n] - less[n]) / (2.0 * step), tolerance) << i << ' ' << grid.y_begin() + j;
        top = std::max(top, std::abs(rows.row(i)[j]));
      }
    }
    EXPECT_GT(maximum(top), 1.0);
  }
}

TEST_P(LinearFilmRows, other_rows_are_the_scaled_change_of_pressure) {
  set_state(0.0);
  std::vector<double> residual(grid.local_size());
  reynolds_residual(equation, U, state, {{}, 40.0}, residual);  // sets the scales
  state.full_film.fill(0.0);
  linearise(equation, 3.0, state, linear);
  apply_stencil(linear, v, u, rows);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      EXPECT_DOUBLE_EQ(rows.row(i)[j],
                       equation.row_scale(j, StateLine(state, i).conductance(j), entrainment, 40.0) * v.row(i)[j]);
    }
  }
}

TEST_P(LinearFilmRows, single_precision_is_the_rounded_double_one) {
  (void)residual_at(0.0, 3.0);
  FilmStencil<float> rounded(grid);
  linearise(equation, 3.0, state, linear);
  linearise(equation, 3.0, state, rounded);
  for (int n = 0; n < neighbour_count; ++n) {
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        EXPECT_EQ(rounded.by_pressure[n].row(i)[j], static_cast<float>(linear.by_pressure[n].row(i)[j]));
        EXPECT_EQ(rounded.by_thickness[n].row(i)[j], static_cast<float>(linear.by_thickness[n].row(i)[j]));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(both, LinearFilmRows, testing::Values(FilmDiscretisation::fitted, FilmDiscretisation::central),
                         [](const auto& tested) {
                           return tested.param == FilmDiscretisation::fitted ? "fitted" : "central";
                         });

}  // namespace
}  // namespace gearfilm

// Reynolds' equation with cavitation: oil properties on the grid, consistency, complementarity.
#include "film/reynolds.hpp"

#include "film/face_flow.hpp"
#include "film_case.hpp"

namespace gearfilm {
namespace {

/// Value and derivatives of a smooth field.
struct Smooth {
  double value, x, y, xx, yy;
};

// c + A sin(k X + s) cos(m Y)
Smooth wave(double constant, double amplitude, double k, double s, double m, double x, double y) {
  const double sine = std::sin(k * x + s), cosine = std::cos(m * y);
  const double fluctuation = amplitude * sine * cosine;
  return {constant + fluctuation, amplitude * k * std::cos(k * x + s) * cosine, -amplitude * m * sine * std::sin(m * y),
          -k * k * fluctuation, -m * m * fluctuation};
}

Smooth pressure_at(double x, double y) { return wave(2.0, 0.7, 1.3, 0.2, 0.9, x, y); }
Smooth film_at(double x, double y) { return wave(1.0, 0.3, 2.1, -0.4, 1.4, x, y); }

constexpr double lambda = 0.8;
constexpr double entrainment = 1.1;

// R of the manufactured pressure and film for xi_R = H^3/lambda, rho = 1.
double exact_residual(double x, double y) {
  const Smooth p = pressure_at(x, y), h = film_at(x, y);
  const double xi = h.value * h.value * h.value / lambda, xi_by_h = 3.0 * h.value * h.value / lambda;
  return -xi * (p.xx + p.yy) - xi_by_h * (h.x * p.x + h.y * p.y) + entrainment * h.x;
}

class Reynolds : public testing::TestWithParam<FilmDiscretisation> {
protected:
  ReynoldsEquation equation_on(const Grid& grid) const { return {grid, isoviscous_scales().C_h, GetParam()}; }

  // An incompressible oil whose viscosity does not depend on pressure.
  static Scales isoviscous_scales() {
    Scales scales = circular_contact().scales;
    scales.oil = {
        .viscosity = 0.04, .pressure_viscosity = 1e-30, .viscosity_law = Barus{}, .density_law = Incompressible{}};
    scales.lambda = lambda;
    return scales;
  }

  /// Residual on own nodes of given pressure and film.
  template <class Pressure, class Film>
  std::vector<double> residual_of(const Grid& grid, FilmState& state, Pressure pressure, Film film,
                                  std::span<const double> squeeze_rate = {}) {
    fill(grid, state.total_pressure, pressure);
    fill(grid, state.thickness, film);
    FilmProperties(isoviscous_scales()).evaluate(state);
    exchange_ghosts(Halo(grid), state);
    std::vector<double> residual(grid.local_size());
    state.entrained.fill(entrainment);
    reynolds_residual(equation_on(grid), in_all_rows(grid, entrainment), state, {squeeze_rate}, residual);
    return residual;
  }

  /// Largest error of the manufactured residual on the inner nodes of lines first..last.
  double manufactured_error(int cells, bool first_line) {
    const Grid grid(PETSC_COMM_WORLD, rectangle(cells + 1, cells + 1, -1.5, 1.0, 1.2));
    FilmState state(grid);
    const auto residual = residual_of(
        grid, state, [](double x, double y) { return pressure_at(x, y).value; },
        [](double x, double y) { return film_at(x, y).value; });
    double error = 0.0;
    for (int i = first_line ? 1 : 2; i < (first_line ? 2 : grid.nx() - 1); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (grid.is_boundary(i, j)) continue;
        EXPECT_EQ(state.full_film.row(i)[j], 1.0);
        error = std::max(error, std::abs(residual[i * grid.y_count() + j] - exact_residual(grid.x(i), grid.y(j))));
      }
    }
    return maximum(error);
  }

  Grid grid_{PETSC_COMM_WORLD, rectangle(17, 13, -1.5, 1.0, 1.2)};
  FilmState state_{grid_};
};

TEST_P(Reynolds, residual_is_second_order_consistent) {
  double coarser = manufactured_error(32, false);
  for (const int cells : {64, 128}) {
    const double finer = manufactured_error(cells, false);
    expect_rate("reynolds_residual", std::log2(coarser / finer));
    coarser = finer;
  }
}

TEST_P(Reynolds, wedge_is_first_order_in_the_first_line) {
  double coarser = manufactured_error(64, true);
  for (const int cells : {128, 256}) {
    const double finer = manufactured_error(cells, true);
    expect_rate("reynolds_first_line", std::log2(coarser / finer));
    coarser = finer;
  }
}

TEST_P(Reynolds, uniform_film_and_pressure_flow_without_residual) {
  const auto residual = residual_of(
      grid_, state_, [](double, double) { return 1.5; }, [](double, double) { return 0.7; });
  for (int i = 1; i < grid_.nx() - 1; ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      if (grid_.is_boundary(i, j)) continue;
      // 1.5 - 2 + 0.5 of a mass flow of order one over h_x.
      EXPECT_NEAR(residual[i * grid_.y_count() + j], 0.0, 1e-13);
    }
  }
}

TEST_P(Reynolds, squeeze_term_is_added_to_the_residual) {
  const auto pressure = [](double x, double y) { return pressure_at(x, y).value; };
  const auto film = [](double x, double y) { return film_at(x, y).value; };
  std::vector<double> rate(grid_.local_size());
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) rate[i * grid_.y_count() + j] = noise(i, grid_.y_begin() + j);
  }
  const auto without = residual_of(grid_, state_, pressure, film);
  const auto with = residual_of(grid_, state_, pressure, film, rate);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      const int n = i * grid_.y_count() + j;
      EXPECT_NEAR(with[n] - without[n], grid_.is_boundary(i, j) ? 0.0 : rate[n], 1e-12);  // round-off of R ~ 1e2
    }
  }
}

// A wave that oil carries, where it conducts nothing: m_X = -q at every node, and R is the error of the wedge. With
// second-order upwind differences it is about (k h)^2/3 of k m; with rates in them 0.02 (k h)^3 and (k h)^4/10.
TEST(FittedWedge, waves_that_oil_carries_have_small_errors_with_rates) {
  constexpr int nodes = 16;  // in a wave
  constexpr double amplitude = 0.2;
  const Grid grid(PETSC_COMM_WORLD, rectangle(65, 13, -1.5, 1.0, 1.2));
  const Scales scales = circular_contact().scales;
  const ReynoldsEquation equation(grid, scales.C_h, FilmDiscretisation::fitted);
  const double k = 2.0 * std::numbers::pi / (nodes * grid.h_x());
  FilmState state(grid);
  state.density.fill(1.0);
  state.total_pressure.fill(1.0);
  state.fluidity.fill(1e-12);
  state.entrained.fill(entrainment);
  fill(grid, state.thickness, [k](double x, double) { return 1.0 + amplitude * std::sin(k * x); });
  exchange_ghosts(Halo(grid), state);
  std::vector<double> rate(grid.local_size()), residual(grid.local_size());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      rate[i * grid.y_count() + j] = -entrainment * k * amplitude * std::cos(k * grid.x(i));
    }
  }
  const auto error = [&](const FaceWeights& of_rates) {
    state.of_rates = of_rates;
    reynolds_residual(equation, in_all_rows(grid, entrainment), state, {rate}, residual);
    double largest = 0.0;
    for (int i = 3; i < grid.nx() - 1; ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (!grid.is_boundary(i, j)) largest = std::max(largest, std::abs(residual[i * grid.y_count() + j]));
      }
    }
    return maximum(largest) / (entrainment * k * amplitude);
  };
  const double kh = 2.0 * std::numbers::pi / nodes;
  EXPECT_GT(error({}), 0.3 * kh * kh);
  EXPECT_LT(error(rates_in_wedge(0.0)), 0.02 * std::pow(kh, 3) + 0.1 * std::pow(kh, 4));
}

// Pressure p up to x_front and none behind, in a uniform film that opens: the node behind the front takes in xi
// p/h_x^2, of which every node has room for its squeeze rate.
TEST_P(Reynolds, oil_pushed_over_a_front_fills_what_has_room_for_it) {
  constexpr int front = 6;
  constexpr double room = 0.3, pressure = 0.03;
  const double pushed = 1.0 / lambda * pressure / (grid_.h_x() * grid_.h_x());
  const int filled = static_cast<int>(std::floor(pushed / room)) - 1;  // besides the node behind the front
  ASSERT_GE(filled, 1);
  const std::vector<double> rate(grid_.local_size(), room);
  const auto residual = residual_of(
      grid_, state_, [&](double x, double) { return x < grid_.x(front) + 1e-9 ? pressure : 0.0; },
      [](double, double) { return 1.0; }, rate);
  for (int i = 1; i < grid_.nx() - 1; ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      if (grid_.is_boundary(i, j)) continue;
      EXPECT_EQ(state_.full_film.row(i)[j], i <= front + 1 + filled ? 1.0 : 0.0) << i;
      if (i <= front + 1) continue;
      EXPECT_NEAR(residual[i * grid_.y_count() + j], i <= front + 1 + filled ? room : 0.0, 1e-12) << i;
    }
  }
}

// With P = 0 everywhere R = U dH/dX: cavitated where the gap opens, a defect of pressure where it closes.
TEST_P(Reynolds, opening_gap_without_pressure_is_cavitated) {
  const auto parabola = [](double x, double) { return 0.5 + 0.5 * x * x; };
  const auto residual = residual_of(
      grid_, state_, [](double, double) { return 0.0; }, parabola);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      const double value = residual[i * grid_.y_count() + j];
      if (grid_.is_boundary(i, j) || grid_.x(i) > 0.0) {
        EXPECT_EQ(state_.full_film.row(i)[j], 0.0);
        EXPECT_EQ(value, 0.0);
      } else {
        EXPECT_EQ(state_.full_film.row(i)[j], 1.0);
        // The second-order wedge is exact for a parabola, the first-order one is off by U h_x/2; two orders blended
        // differ by U 3/8 h_x^2 at a face, times what theta changes by.
        const double exact = entrainment * (grid_.x(i) - (i == 1 ? 0.5 * grid_.h_x() : 0.0));
        const double blended = (i == 1 ? 0.4 : 0.05) * entrainment * grid_.h_x();
        EXPECT_NEAR(value, exact, GetParam() == FilmDiscretisation::central ? 1e-13 : blended);
      }
    }
  }
}

// R itself is seen through a squeeze rate so negative that every inner node is full.
TEST_P(Reynolds, residual_is_the_smaller_of_scaled_pressure_and_flow) {
  constexpr double suction = 1e6;
  const std::vector<double> sucking(grid_.local_size(), -suction);
  const ReynoldsEquation equation = equation_on(grid_);
  const auto pressure = [&](double x, double y) { return std::sin(17.0 * x + 3.0) * std::sin(13.0 * y + 1.0); };
  const auto film = [](double x, double y) { return film_at(x, y).value; };
  const auto shifted = residual_of(grid_, state_, pressure, film, sucking);
  const auto residual = residual_of(grid_, state_, pressure, film);
  int counts[2] = {0, 0};
  for (int i = 1; i < grid_.nx() - 1; ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      if (grid_.is_boundary(i, j)) continue;
      const int n = i * grid_.y_count() + j;
      const double flow = shifted[n] + suction;
      const double scaled = equation.row_scale(j, StateLine(state_, i).conductance(j), entrainment, 0.0) *
                            state_.total_pressure.row(i)[j];
      EXPECT_NEAR(residual[n], std::min(scaled, flow), 1e-8);  // round-off of the suction, 1e-10
      EXPECT_EQ(state_.full_film.row(i)[j], flow < scaled ? 1.0 : 0.0);
      ++counts[flow < scaled];
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_GT(counts[0], 10);
  EXPECT_GT(counts[1], 10);
}

TEST_P(Reynolds, row_scale_is_poiseuille_diagonal_and_a_part_of_the_wedge) {
  const ReynoldsEquation equation = equation_on(grid_);
  const double h_x = grid_.h_x(), h_y = grid_.h_y(), xi = 0.3;
  EXPECT_DOUBLE_EQ(equation.row_scale(0, xi, entrainment, 0.0),
                   2.0 * xi * (1.0 / (h_x * h_x) + 1.0 / (h_y * h_y)) + 0.05 * entrainment / h_x);
  EXPECT_DOUBLE_EQ(equation.row_scale(0, xi, entrainment, 40.0) - equation.row_scale(0, xi, entrainment, 0.0),
                   0.05 * 40.0);
  // On the boundary and at cavitated nodes the row is d P, with the node's own d.
  const auto residual = residual_of(
      grid_, state_, [](double x, double y) { return -pressure_at(x, y).value; },
      [](double x, double y) { return film_at(x, y).value; });
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      if (!grid_.is_boundary(i, j)) continue;
      const double expected = equation.row_scale(j, StateLine(state_, i).conductance(j), entrainment, 0.0) *
                              state_.total_pressure.row(i)[j];
      EXPECT_EQ(state_.full_film.row(i)[j], 0.0);
      EXPECT_DOUBLE_EQ(residual[i * grid_.y_count() + j], expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(both, Reynolds, testing::Values(FilmDiscretisation::fitted, FilmDiscretisation::central),
                         [](const auto& tested) {
                           return tested.param == FilmDiscretisation::fitted ? "fitted" : "central";
                         });

TEST(FilmProperties, conductance_and_its_derivatives_follow_the_oil) {
  const Scales scales = table3_pitch().scales;
  const Grid grid(PETSC_COMM_WORLD, rectangle(9, 9, -1.0, 1.0, 1.0));
  const FilmProperties properties(scales);
  const auto state_at = [&](double pressure_change, double film_change) {
    FilmState state(grid);
    fill(grid, state.total_pressure, [&](double x, double y) { return pressure_change + 0.5 + 0.2 * x + 0.1 * y; });
    fill(grid, state.thickness, [&](double x, double y) { return film_change + 0.1 - 0.02 * x + 0.05 * y; });
    properties.evaluate(state);
    return state;
  };
  // Central differences: off by (step/scale of change)^2 ~ (1e-5 * 20)^2/6, and by round-off/step.
  constexpr double step = 1e-5, tolerance = 1e-7;
  const FilmState state = state_at(0.0, 0.0);
  const FilmState more_p = state_at(step, 0.0), less_p = state_at(-step, 0.0);
  const FilmState more_h = state_at(0.0, step), less_h = state_at(0.0, -step);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      const double p = scales.pressure * state.total_pressure.row(i)[j], h = state.thickness.row(i)[j];
      const double density = relative_density(scales.oil, p).value;
      const double viscosity = std::exp(log_relative_viscosity(scales.oil, p).value);
      const double xi = density * h * h * h / (viscosity * scales.lambda);
      EXPECT_DOUBLE_EQ(state.density.row(i)[j], density);
      const StateLine line(state, i);
      EXPECT_NEAR(line.conductance(j), xi, 1e-13 * xi);  // exponent of order 20: its round-off times 20
      EXPECT_NEAR(line.phi[j] * scales.lambda, std::exp(line.f[j]), 1e-13 * line.phi[j] * scales.lambda);
      const auto conductance_by = [&](const FilmState& more, const FilmState& less) {
        return (StateLine(more, i).conductance(j) - StateLine(less, i).conductance(j)) / (2.0 * step);
      };
      const double xi_p = line.conductance_by_pressure(j), xi_h = line.conductance_by_thickness(j);
      const double by_p = (more_p.density.row(i)[j] - less_p.density.row(i)[j]) / (2.0 * step);
      EXPECT_NEAR(by_p, line.rho_p[j], tolerance * line.rho_p[j]);
      EXPECT_NEAR(conductance_by(more_p, less_p), xi_p, tolerance * std::abs(xi_p));
      EXPECT_NEAR(conductance_by(more_h, less_h), xi_h, tolerance * xi_h);
    }
  }
}

TEST(FilmProperties, film_below_zero_conducts_nothing) {
  const Grid grid(PETSC_COMM_WORLD, rectangle(5, 9, -1.0, 1.0, 1.0));
  FilmState state(grid);
  fill(grid, state.thickness, [](double x, double) { return x - 2.0; });
  FilmProperties(table3_pitch().scales).evaluate(state);
  for (int i = 0; i < grid.nx(); ++i) {
    const StateLine line(state, i);
    for (int j = 0; j < grid.y_count(); ++j) {
      EXPECT_EQ(line.conductance(j), 0.0);
      EXPECT_EQ(line.conductance_by_thickness(j), 0.0);
      EXPECT_EQ(line.conductance_by_pressure(j), 0.0);
    }
  }
}

}  // namespace
}  // namespace gearfilm

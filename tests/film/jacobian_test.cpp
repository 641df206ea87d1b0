// The matrix-free Jacobian of the film against its residual, about a converged film with cavitated nodes.
#include <tuple>

#include "film_case.hpp"

namespace gearfilm {
namespace {

/// A change of the state.
struct Direction {
  const char* name;
  double pressure;  ///< of its change, times direction_at()
  double H0;
};

std::ostream& operator<<(std::ostream& out, const Direction& direction) { return out << direction.name; }

class Jacobian : public testing::TestWithParam<std::tuple<double, Direction>> {
protected:
  Jacobian() {
    static const FilmSolution solution = film_away_from_pitch(65, 33);
    move_surfaces(film, away_from_pitch());
    pressure = own_part(grid, solution.pressure);
    H0 = solution.H0;
    film.mass(pressure, H0, mass_before);
  }

  /// G at x + e v, with the squeeze term shift (rho H - its value at x).
  std::vector<double> residual_at(double shift, double step, const std::vector<double>& change, double change_H0) {
    std::vector<double> moved(pressure), rate(grid.local_size()), residual(grid.local_size());
    for (std::size_t n = 0; n < moved.size(); ++n) moved[n] += step * change[n];
    const double moved_H0 = H0 + step * change_H0;
    film.mass(moved, moved_H0, rate);
    for (std::size_t n = 0; n < rate.size(); ++n) rate[n] = shift * (rate[n] - mass_before[n]);
    film.residual(moved, moved_H0, {shift != 0.0 ? std::span<const double>(rate) : std::span<const double>()},
                  residual);
    return residual;
  }

  /// At x, where the squeeze term vanishes.
  void linearise(double shift) {
    const std::vector<double> still(grid.local_size(), 0.0);
    film.linearise(pressure, H0, {shift != 0.0 ? std::span<const double>(still) : std::span<const double>()}, shift);
  }

  /// Rows differ by ten orders of magnitude from inlet to centre: each is divided by its own scale d.
  void keep_row_scales() {
    FilmState state(grid);
    state.total_pressure = film.total_pressure();
    state.thickness = film.thickness();
    FilmProperties(contact.scales).evaluate(state);
    const ReynoldsEquation& equation = film.discretisation()->equation();
    for (int i = 0; i < grid.nx(); ++i) {
      const StateLine line(state, i);
      for (int j = 0; j < grid.y_count(); ++j) {
        const double U = film.surfaces().entrainment[j];
        row_scale[i * grid.y_count() + j] = equation.row_scale(j, line.conductance(j), U, 0.0);
      }
    }
  }

  double norm(const std::vector<double>& rows) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < rows.size(); ++n) sum += rows[n] * rows[n] / (row_scale[n] * row_scale[n]);
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return std::sqrt(sum);
  }

  // Zero on the boundary; small where the pressure is, so that no node changes between full and cavitated (there the
  // residual has a kink).
  std::vector<double> direction_at(double amplitude) const {
    std::vector<double> change(grid.local_size(), 0.0);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (grid.is_boundary(i, j)) continue;
        const int n = i * grid.y_count() + j;
        const double wave =
            std::sin(2.3 * grid.x(i) + 0.4) * std::cos(0.6 * grid.y(j) + 0.5) + 0.3 * noise(i, grid.y_begin() + j);
        change[n] = amplitude * wave * (pressure[n] > 0.0 ? pressure[n] : 1e-4);
      }
    }
    return change;
  }

  FilmCase contact = table3_pitch();
  Grid grid{PETSC_COMM_WORLD, contact.shape(65, 33)};
  ContactFilm film{discretise(grid, contact.scales), contact.scales,
                   MultigridOptions{.precision = Precision::double_precision}};
  std::vector<double> pressure;
  double H0 = 0.0;
  std::vector<double> mass_before = std::vector<double>(grid.local_size());
  std::vector<double> row_scale = std::vector<double>(grid.local_size());
};

// |G(x + e v) - G(x) - e J v| falls like e^2.
TEST_P(Jacobian, jacobian_passes_taylor_test) {
  const auto& [shift, direction] = GetParam();
  const auto change = direction_at(direction.pressure);
  const auto at_state = residual_at(shift, 0.0, change, 0.0);
  keep_row_scales();
  linearise(shift);
  std::vector<double> slope(grid.local_size());
  film.multiply(change, direction.H0, slope);
  // At the state itself J v must matter against the remainder: a slope of zero would pass as well.
  EXPECT_GT(norm(slope), 1e-4);
  double before = 0.0;
  for (const double step : {4e-3, 2e-3, 1e-3, 5e-4}) {
    auto remainder = residual_at(shift, step, change, direction.H0);
    for (std::size_t n = 0; n < remainder.size(); ++n) remainder[n] -= at_state[n] + step * slope[n];
    const double size = norm(remainder);
    if (before > 0.0) expect_rate("jacobian_taylor_remainder", std::log2(before / size));
    before = size;
  }
}

TEST_P(Jacobian, displacement_column_is_that_of_H0) {
  const double shift = std::get<0>(GetParam());
  const std::vector<double> none(grid.local_size(), 0.0);
  linearise(shift);
  const std::span<const double> column = film.displacement_column();
  std::vector<double> product(grid.local_size());
  film.multiply(none, 1.0, product);
  // The same six numbers added in another order.
  for (std::size_t n = 0; n < column.size(); ++n)
    EXPECT_NEAR(product[n], column[n], 1e-10 * (1.0 + std::abs(column[n])));
}

INSTANTIATE_TEST_SUITE_P(with_and_without_squeeze, Jacobian,
                         testing::Combine(testing::Values(0.0, 30.0),
                                          testing::Values(Direction{"pressure", 1.0, 0.0}, Direction{"H0", 0.0, 1e-2},
                                                          Direction{"both", 1.0, -1e-2})),
                         [](const auto& tested) {
                           return std::string(std::get<1>(tested.param).name) +
                                  (std::get<0>(tested.param) > 0.0 ? "_with_squeeze" : "_stationary");
                         });

}  // namespace
}  // namespace gearfilm

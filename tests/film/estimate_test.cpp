// Error bars: what quantities on two grids say of finer ones.
#include "numerics/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "film/pressure_spike.hpp"
#include "film_case.hpp"

namespace gearfilm {
namespace {

TEST(Estimate, of_second_order_is_the_error_itself) {
  for (const double ratio : {2.0, std::sqrt(2.0)}) {
    const double limit = 3.0, error = -0.1;
    const Estimate found = estimate(limit + error, limit + ratio * ratio * error, ratio);
    EXPECT_NEAR(found.error, std::abs(error), 1e-12);
    EXPECT_NEAR(found.extrapolated.value(), limit, 1e-12);
  }
}

TEST(Estimate, is_relative_to_the_value_that_is_printed) {
  Estimate found = estimate(1.0, 0.1);
  EXPECT_DOUBLE_EQ(found.relative_error(), 0.3);
  found.least = 2.0;
  EXPECT_DOUBLE_EQ(found.relative_error(), 0.15);
}

TEST(Estimate, of_errors_of_third_order_that_may_change_sign_is_a_bound) {
  const auto film = [](double step) { return 1.0 + 0.01 * step * step * step; };
  const Estimate found = estimate_fast(film(1.0), film(2.0), 0.002);
  EXPECT_NEAR(*found.extrapolated, 1.0, 1e-12);
  EXPECT_NEAR(found.error, 0.25 * 0.07, 1e-12);
  EXPECT_GT(found.error, film(1.0) - 1.0);
  // Where the sign changes two grids may agree.
  EXPECT_DOUBLE_EQ(estimate_fast(2.0, 2.0, 0.002).error, 0.004);
}

// Orders as low as 1.3 were seen of smallest films.
TEST(Estimate, of_a_smallest_film_holds_the_film_of_doubled_nodes_at_low_orders) {
  const double limit = 1.0, order = 1.3;
  const auto film = [&](double h) { return limit - 0.01 * std::pow(h, order); };
  const Estimate found = estimate_smallest(film(1.0), film(2.0));
  EXPECT_LT(std::abs(film(0.5) - film(1.0)), found.error);
}

TEST(Estimate, of_the_largest_pressure_is_that_of_second_order_while_the_spike_is_low) {
  const double step = 0.02;
  const Estimate found = estimate_largest({1.00, 0.5}, {1.03, 0.45}, step);
  EXPECT_NEAR(found.error, 0.015, 1e-12);
  EXPECT_NEAR(found.extrapolated.value(), 0.99, 1e-12);
}

TEST(Estimate, of_the_largest_pressure_holds_a_spike_that_takes_over) {
  const double step = 0.02;
  const Estimate found = estimate_largest({1.0, 0.95}, {1.0, 0.86}, step);
  EXPECT_GT(found.error, 0.95 * 0.95 / 0.86 - 1.0);
  EXPECT_FALSE(found.extrapolated);
}

// Differences of a spike's height say little on some grids: it grows by so much later.
TEST(Estimate, of_a_spike_is_no_less_than_two_doublings_were_seen_to_add) {
  const Estimate found = estimate_spike(0.7573, 0.7351).value();
  EXPECT_GT(found.error, 0.8572 - 0.7573);
  EXPECT_FALSE(found.extrapolated);
  EXPECT_FALSE(estimate_spike(0.0, 0.0));
}

TEST(Estimate, of_a_spike_does_not_depend_on_the_ratio_of_the_grids) {
  const auto height = [](double h) { return std::pow(h, -0.2); };
  const double twice = estimate_spike(height(1.0), height(2.0), 2.0)->error;
  EXPECT_NEAR(estimate_spike(height(1.0), height(std::sqrt(2.0)), std::sqrt(2.0))->error, twice, 1e-12);
}

/// Largest over all processes, of a pressure given along X on the first row and a tenth of it on the others.
double spike_of(const std::vector<double>& line) {
  const Grid grid(PETSC_COMM_WORLD, rectangle(static_cast<int>(line.size()), 17, -2.0, 1.2, 1.0));
  Field<double> pressure(grid);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) pressure.row(i)[j] = (grid.y_begin() + j == 0 ? 1.0 : 0.1) * line[i];
  }
  double spike = spike_pressure(grid, pressure);
  MPI_Allreduce(MPI_IN_PLACE, &spike, 1, MPI_DOUBLE, MPI_MAX, grid.comm());
  return spike;
}

TEST(PressureSpike, is_what_rises_behind_the_valley) {
  EXPECT_DOUBLE_EQ(spike_of({0, 0.3, 0.9, 1.0, 0.9, 0.7, 0.6, 0.8, 0.1, 0, 0}), 0.8);
  EXPECT_DOUBLE_EQ(spike_of({0, 0.3, 0.9, 1.0, 0.9, 0.7, 0.6, 1.8, 0.1, 0, 0}), 1.8);
}

TEST(PressureSpike, is_the_only_maximum_where_that_is_sharp) {
  EXPECT_DOUBLE_EQ(spike_of({0, 0.3, 0.5, 0.6, 0.65, 0.7, 0.75, 0.9, 0.1, 0, 0}), 0.9);
}

TEST(PressureSpike, is_not_there_on_a_smooth_pressure) {
  EXPECT_EQ(spike_of({0, 0.3, 0.8, 0.96, 1.0, 0.96, 0.8, 0.3, 0, 0, 0}), 0.0);
  EXPECT_EQ(spike_of({0, 0.3, 0.8, 0.96, 1.0, 0.9999999, 1.0, 0.96, 0.8, 0.3, 0}), 0.0);
}

}  // namespace
}  // namespace gearfilm

// What points of a known map say of its recurrence and its multipliers.
#include "orbits/poincare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

/// Points of x -> c + modulus R(angle) (x - c), shifted by +-jump from one to the next.
std::vector<PoincarePoint> spiral(double modulus, double angle, int count, double jump = 0.0) {
  std::vector<PoincarePoint> points;
  double H = 0.1, V = 0.0;
  for (int n = 0; n < count; ++n) {
    const double side = n % 2 == 0 ? jump : -jump;
    points.push_back({.T = 7.5 * n, .motion = {-1.5 + H + side, 1.2 + V}});
    const double next = modulus * (std::cos(angle) * H - std::sin(angle) * V);
    V = modulus * (std::sin(angle) * H + std::cos(angle) * V);
    H = next;
  }
  return points;
}

TEST(Poincare, a_spiral_settles_by_its_multiplier) {
  const auto points = spiral(0.954, 2.05, 40);
  const auto recurrence = recurrence_of(points, 1e-3);
  ASSERT_TRUE(recurrence);
  EXPECT_EQ(recurrence->period, 0);
  const auto settling = settling_of(points, *recurrence);
  ASSERT_TRUE(settling);
  EXPECT_NEAR(std::abs(settling->multiplier), 0.954, 1e-9);
  EXPECT_NEAR(std::abs(std::arg(settling->multiplier)), 2.05, 1e-9);
}

TEST(Poincare, a_motion_that_repeats_every_second_period_says_so) {
  const auto points = spiral(0.8, 1.0, 60, 0.3);
  const auto recurrence = recurrence_of(points, 1e-3);
  ASSERT_TRUE(recurrence);
  EXPECT_EQ(recurrence->period, 2);
  EXPECT_LT(recurrence->defect, 1e-3);
  const auto settling = settling_of(points, *recurrence);
  ASSERT_TRUE(settling);
  EXPECT_EQ(settling->period, 2);
  EXPECT_NEAR(std::abs(settling->multiplier), 0.64, 0.01);
}

TEST(Poincare, a_swing_of_nearly_three_periods_that_dies_away_settles_on_one) {
  const auto points = spiral(0.95, 2.0 * std::numbers::pi / 3.0 + 0.01, 60);
  ASSERT_LT(length(difference(points[59].motion, points[56].motion)), 1e-3);
  const auto recurrence = recurrence_of(points, 1e-3);
  ASSERT_TRUE(recurrence);
  EXPECT_EQ(recurrence->period, 0);
  const auto settling = settling_of(points, *recurrence);
  ASSERT_TRUE(settling);
  EXPECT_EQ(settling->period, 1);
  EXPECT_NEAR(std::abs(settling->multiplier), 0.95, 1e-6);
}

TEST(Poincare, a_march_on_its_way_to_two_periods_settles_over_two) {
  const auto points = spiral(0.95, 1.0, 40, 0.3);
  const auto recurrence = recurrence_of(points, 1e-3);
  ASSERT_TRUE(recurrence);
  EXPECT_EQ(recurrence->period, 0);
  const auto settling = settling_of(points, *recurrence);
  ASSERT_TRUE(settling);
  EXPECT_EQ(settling->period, 2);
  EXPECT_NEAR(std::abs(settling->multiplier), 0.95 * 0.95, 1e-6);
}

TEST(Poincare, few_points_say_nothing) {
  EXPECT_FALSE(recurrence_of(spiral(0.9, 1.0, 1), 1e-3));
  const auto points = spiral(0.9, 1.0, 4);
  EXPECT_FALSE(settling_of(points, *recurrence_of(points, 1e-3)));
}

}  // namespace
}  // namespace gearfilm

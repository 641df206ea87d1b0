// How far linear systems are solved, by a residual whose curvature is known: |r|^2 comes back as c |r|.
#include "numerics/solve_tolerance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gearfilm {
namespace {

constexpr SolveBounds bounds{.loosest = 0.2, .tightest = 3e-4};
constexpr double of_curvature = 0.3, left_over = 0.5, loosest_last = 0.2;  // as docs/constants.md has them

/// A Newton method whose linear solves leave just what they may, at right angles to what curvature brings back.
struct Method {
  double curvature;
  double aim = 1e-9;
  SolveTolerance tolerance{bounds};
  std::vector<double> asked{};

  /// From a norm to the aim.
  void solve(double norm) {
    asked.clear();
    double linear = 0.0;
    for (int iteration = 0; norm > aim; ++iteration) {
      asked.push_back(tolerance.next(iteration, norm, linear, aim));
      linear = asked.back() * norm;
      norm = std::hypot(linear, curvature * norm * norm);
    }
  }
};

TEST(SolveTolerance, is_the_loosest_while_nothing_is_known) {
  SolveTolerance tolerance(bounds);
  EXPECT_DOUBLE_EQ(tolerance.next(0, 1.0, 0.0, 1e-9), bounds.loosest);
}

TEST(SolveTolerance, is_a_part_of_what_curvature_will_bring_back) {
  Method method{.curvature = 0.1};
  method.solve(1.0);
  // c = 0.1 of the first residual, 1, and hypot(0.2, 0.1) of that in the second.
  EXPECT_NEAR(method.asked[1], of_curvature * 0.1 * std::hypot(0.2, 0.1), 1e-12);
  // The next solve knows c from its first iteration on.
  method.solve(0.5);
  EXPECT_NEAR(method.asked[0], of_curvature * 0.1 * 0.5, 1e-12);
}

TEST(SolveTolerance, goes_all_of_the_way_where_curvature_brings_nothing_back) {
  Method method{.curvature = 0.0, .aim = 1e-3};
  method.solve(1.0);
  method.solve(0.9);
  EXPECT_NEAR(method.asked[0], left_over * method.aim / 0.9, 1e-12);
  EXPECT_EQ(method.asked.size(), 1U);
}

TEST(SolveTolerance, keeps_to_its_bounds) {
  Method method{.curvature = 1e-6};
  method.solve(1.0);
  method.solve(1.0);
  EXPECT_DOUBLE_EQ(method.asked[0], bounds.tightest);
  Method strong{.curvature = 0.95};
  strong.solve(1.0);
  EXPECT_DOUBLE_EQ(strong.asked[1], bounds.loosest);
  // What ends the iteration may be looser than what the bounds allow before.
  SolveTolerance narrow({.loosest = 0.01, .tightest = 0.01});
  EXPECT_DOUBLE_EQ(narrow.next(0, 2.0, 0.0, 1.0), loosest_last);
}

}  // namespace
}  // namespace gearfilm

// A rigid shaft on two bearings against the equilibrium of its forces and moments.
#include "train/two_bearings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace gearfilm {
namespace {

TEST(TwoBearings, give_way_and_tilt_as_a_rigid_shaft_does) {
  const Eigen::Matrix2d first{{2e8, 5e7}, {5e7, 3e8}};
  for (const double offset : {0.0, 0.01, -0.07}) {
    const TwoBearings bearings{.span = 0.08, .offset = offset, .stiffness = first, .ratio = 1.5};
    const double a = -0.04 - offset, b = 0.04 - offset;
    const Eigen::Matrix2d second = first / 1.5;
    // Displacement u of the gear's middle and tilt du/dy, under a force and its moment.
    Eigen::Matrix4d stiffness;
    stiffness << first + second, a * first + b * second, a * first + b * second, a * a * first + b * b * second;
    const Eigen::Vector2d n(0.34, 0.94);
    const auto way_by = [&](double force, double moment) -> Eigen::Vector4d {
      return stiffness.inverse() * (Eigen::Vector4d() << force * n, moment * n).finished();
    };
    const Eigen::Vector2d u = bearings.at_gear().inverse() * n;
    EXPECT_LT((u - way_by(1.0, 0.0).head(2)).norm(), 1e-9 * u.norm());
    const double by_force = n.dot(way_by(1.0, 0.0).tail(2)), by_moment = n.dot(way_by(0.0, 1.0).tail(2));
    EXPECT_NEAR(bearings.tilt_by_force(n), by_force, 1e-9 * std::abs(by_moment));
    EXPECT_NEAR(bearings.tilt_by_moment(n), by_moment, 1e-9 * by_moment);
  }
}

TEST(TwoBearings, that_are_equal_with_the_gear_in_the_middle_do_not_tilt) {
  const Eigen::Matrix2d each = 3e8 * Eigen::Matrix2d::Identity();
  const TwoBearings bearings{.span = 0.07, .stiffness = each};
  EXPECT_EQ(bearings.tilt_by_force({0.34, 0.94}), 0.0);
  EXPECT_EQ(bearings.at_gear(), 2.0 * each);
}

}  // namespace
}  // namespace gearfilm

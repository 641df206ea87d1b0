// Searches, branches and fits of motions with two degrees of freedom: maps in four dimensions whose fixed points,
// multipliers and bifurcations are known in closed form.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "orbits/affine_fit.hpp"
#include "orbits/continuation.hpp"
#include "orbits/free_decay.hpp"
#include "orbits/map_jacobian.hpp"
#include "orbits/poincare.hpp"

namespace gearfilm::two_freedoms {
namespace {

/// x = Q z: what is known in z is mixed among all four coordinates.
const Eigen::Matrix4d Q{{1.0, 0.3, -0.2, 0.1}, {0.2, 0.9, 0.4, -0.3}, {-0.1, 0.2, 1.1, 0.5}, {0.3, -0.4, 0.2, 0.8}};

Motion motion_at(const Eigen::Vector4d& z) { return to_motion(Q * z); }
Eigen::Vector4d normal_form_of(const Motion& motion) { return Q.inverse() * to_vector(motion); }

/// One step of a map of z.
struct Step {
  Eigen::Vector4d image;
  Eigen::Matrix4d by_z;
  Eigen::Vector4d by_parameter;
};
using StepOf = Step (*)(const Eigen::Vector4d& z, double lambda);

BranchMap repeated(StepOf step) {
  return [step](const BranchState& at, int order) {
    MapValue value;
    value.by_motion = Monodromy::Identity(4, 4);
    Eigen::Vector4d z = normal_form_of(at.motion), by_parameter = Eigen::Vector4d::Zero();
    for (int n = 0; n < order; ++n) {
      const Step one = step(z, at.parameter);
      by_parameter = one.by_z * by_parameter + one.by_parameter;
      value.by_motion = Q * one.by_z * Q.inverse() * value.by_motion;
      z = one.image;
      value.states.push_back(motion_at(z));
    }
    value.by_parameter = motion_at(by_parameter);
    return value;
  };
}

Eigen::Matrix2d rotation(double modulus, double angle) {
  return modulus * Eigen::Matrix2d{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
}

/// z_1' = z_1 + lambda - z_1^2 beside a decay and a decaying swing: z_1 = +-sqrt(lambda), a fold at 0, a flip at
/// lambda = 1, from which the motion of period 2 is 1 +- sqrt(lambda - 1); multipliers 1 - 2 z_1, 0.5, 0.8 exp(+-0.7
/// i).
Step quadratic(const Eigen::Vector4d& z, double lambda) {
  Step step{z, Eigen::Matrix4d::Zero(), Eigen::Vector4d::UnitX()};
  step.by_z(0, 0) = 1.0 - 2.0 * z[0];
  step.by_z(1, 1) = 0.5;
  step.by_z.bottomRightCorner<2, 2>() = rotation(0.8, 0.7);
  step.image = step.by_z * z;
  step.image[0] = z[0] + lambda - z[0] * z[0];
  return step;
}

/// A swing that grows by lambda beside two real multipliers, lambda + 0.5 and 0.8: their product is 1 at 0.75, which is
/// no bifurcation.
Step growing_swing(const Eigen::Vector4d& z, double lambda) {
  Step step{z, Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
  step.by_z(0, 0) = lambda + 0.5;
  step.by_z(1, 1) = 0.8;
  step.by_z.bottomRightCorner<2, 2>() = rotation(lambda, 1.0);
  step.image = step.by_z * z;
  step.by_parameter[0] = z[0];
  step.by_parameter.tail<2>() = rotation(1.0, 1.0) * z.tail<2>();
  return step;
}

struct Found {
  int branch;
  PointKind kind;
  BranchPoint point;
};

std::vector<Found> follow(StepOf step, const BranchState& start, bool upwards, const ContinuationOptions& options) {
  std::vector<Found> found;
  follow_branches(repeated(step), 1, start, upwards, options,
                  [&](const Branch& branch, PointKind kind, const BranchPoint& point) {
                    found.push_back({branch.number, kind, point});
                  });
  return found;
}

std::vector<double> parameters_of(const std::vector<Found>& points, PointKind kind, int branch) {
  std::vector<double> parameters;
  for (const Found& at : points) {
    if (at.kind == kind && at.branch == branch) parameters.push_back(at.point.state.parameter);
  }
  return parameters;
}

constexpr double located = 2e-6;  // of 1e-6 of the branch's length

TEST(TwoFreedoms, multipliers_are_those_of_the_blocks_the_largest_first) {
  Eigen::Matrix4d blocks = quadratic({0.95, 0.0, 0.0, 0.0}, 0.0).by_z;
  const Multipliers mu = multipliers(Q * blocks * Q.inverse());
  ASSERT_EQ(mu.size(), 4u);
  const Multipliers expected = {-0.9, std::polar(0.8, 0.7), std::polar(0.8, -0.7), 0.5};
  for (std::size_t n = 0; n < 4; ++n) EXPECT_LT(std::abs(mu[n] - expected[n]), 1e-12) << n;
  EXPECT_NEAR(largest_modulus(mu), 0.9, 1e-12);
}

TEST(TwoFreedoms, a_branch_passes_its_fold_and_flips) {
  const std::vector<Found> found =
      follow(quadratic, {motion_at({0.71, 0.0, 0.0, 0.0}), 0.5}, false, {.lowest = -1.0, .highest = 0.6});
  const std::vector<double> folds = parameters_of(found, PointKind::fold, 1);
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_NEAR(folds[0], 0.0, located);
  for (const Found& at : found) {
    const Eigen::Vector4d z = normal_form_of(at.point.state.motion);
    EXPECT_NEAR(at.point.state.parameter, z[0] * z[0], 1e-8);
    EXPECT_LT(z.tail<3>().norm(), 1e-8);
    if (at.kind == PointKind::regular) {
      EXPECT_EQ(at.point.stable(), z[0] > 0.0);
    }
  }
}

TEST(TwoFreedoms, the_doubled_period_is_followed_from_its_flip) {
  const std::vector<Found> found = follow(quadratic, {motion_at({0.8, 0.0, 0.0, 0.0}), 0.64}, true,
                                          {.lowest = 0.6, .highest = 1.2, .largest_order = 2});
  const std::vector<double> flips = parameters_of(found, PointKind::flip, 1);
  ASSERT_EQ(flips.size(), 1u);
  EXPECT_NEAR(flips[0], 1.0, located);
  int doubled = 0;
  for (const Found& at : found) {
    if (at.branch != 2 || at.kind != PointKind::regular) continue;
    const double z = normal_form_of(at.point.state.motion)[0];
    EXPECT_NEAR(std::abs(z - 1.0), std::sqrt(at.point.state.parameter - 1.0), 1e-6);
    EXPECT_TRUE(at.point.stable());
    ++doubled;
  }
  EXPECT_GT(doubled, 3);
}

TEST(TwoFreedoms, a_swing_that_begins_to_grow_is_found_and_two_real_multipliers_are_not) {
  const std::vector<Found> found =
      follow(growing_swing, {motion_at(Eigen::Vector4d::Zero()), 0.6}, true, {.lowest = 0.6, .highest = 1.5});
  const std::vector<double> born = parameters_of(found, PointKind::neimark_sacker, 1);
  ASSERT_EQ(born.size(), 1u);
  EXPECT_NEAR(born[0], 1.0, located);
}

/// Motions that films damp within a period are found as soon as they are marched, from however far.
TEST(TwoFreedoms, newton_steps_go_as_far_as_the_map_does) {
  const Motion defect = motion_at({7.0, 0.3, -0.2, 0.1});
  EXPECT_LT(length(difference(MapJacobian(2, 0.4, {}).newton_step(defect, 0.5), defect)), 1e-12);
  const Monodromy nearly_one = 0.99 * Monodromy::Identity(4, 4);
  EXPECT_NEAR(MapJacobian(2, 0.4, nearly_one).newton_step(defect, 0.5).H0(), defect.H0(), 1e-12);
  EXPECT_NEAR(MapJacobian(2, 0.4, nearly_one).newton_step(to_motion(0.01 * to_vector(defect)), 0.5).H0(), 0.5, 1e-12);
}

/// Newton's method from a bad guess with the Jacobian of another parameter, as the search for an orbit goes: Broyden's
/// updates make of it that of the fixed point, along the way that was gone.
TEST(TwoFreedoms, a_search_with_the_jacobian_of_another_parameter_finds_the_fixed_point) {
  constexpr double lambda = 0.3, worth = 0.4;
  const BranchMap map = repeated(quadratic);
  Motion x = motion_at({0.75, 0.1, -0.1, 0.2});
  MapJacobian jacobian(2, worth, map({x, 0.5}, 1).by_motion);
  Motion image = map({x, lambda}, 1).image();
  int steps = 0;
  for (; length(difference(image, x)) > 1e-12 && steps < 30; ++steps) {
    const Motion defect = difference(image, x), step = jacobian.newton_step(defect, 0.1);
    EXPECT_LE(length({step.q, worth * step.v}), std::max(0.1, length({defect.q, worth * defect.v})) + 1e-12);
    const Motion next{x.q + step.q, x.v + step.v}, next_image = map({next, lambda}, 1).image();
    jacobian.update(step, difference(next_image, image));
    EXPECT_LT((jacobian.monodromy() * to_vector(step) - to_vector(difference(next_image, image))).norm(), 1e-12);
    x = next;
    image = next_image;
  }
  EXPECT_LT(steps, 15);
  const Eigen::Vector4d z = normal_form_of(x);
  EXPECT_NEAR(z[0], std::sqrt(lambda), 1e-10);
  EXPECT_LT(z.tail<3>().norm(), 1e-10);
}

TEST(TwoFreedoms, a_push_decays_by_all_four_multipliers) {
  const Monodromy map = Q * quadratic({0.15, 0.0, 0.0, 0.0}, 0.0).by_z * Q.inverse();
  const Motion orbit = motion_at({0.4, -0.2, 0.1, 0.3});
  std::vector<Returns> pushes;
  for (const double sign : {1.0, -1.0}) {
    Returns motions = {motion_at({0.4 + sign * 0.005, -0.198, 0.103, 0.301 - sign * 0.002})};
    for (int n = 0; n < 8; ++n) {
      motions.push_back(to_motion(to_vector(orbit) + map * to_vector(difference(motions.back(), orbit))));
    }
    pushes.push_back(motions);
  }
  const FreeDecay decay = fit_decay(pushes, orbit, orbit);
  const Multipliers expected = {std::polar(0.8, 0.7), std::polar(0.8, -0.7), 0.7, 0.5};
  ASSERT_EQ(decay.multipliers.size(), 4u);
  for (std::size_t n = 0; n < 4; ++n) EXPECT_LT(std::abs(decay.multipliers[n] - expected[n]), 1e-6) << n;
  EXPECT_LT(decay.modulus_error(), 1e-6);
}

TEST(TwoFreedoms, a_march_settles_by_its_largest_multiplier) {
  const Monodromy map = Q * quadratic({0.15, 0.0, 0.0, 0.0}, 0.0).by_z * Q.inverse();
  const Motion rest = motion_at({0.4, -0.2, 0.1, 0.3});
  std::vector<PoincarePoint> points;
  Motion x = motion_at({0.5, -0.15, 0.05, 0.35});
  for (int n = 0; n < 20; ++n) {
    points.push_back({.T = static_cast<double>(n), .motion = x});
    x = to_motion(to_vector(rest) + map * to_vector(difference(x, rest)));
  }
  const Recurrence recurrence = recurrence_of(points, 1e-4).value();
  EXPECT_EQ(recurrence.period, 0) << "not yet";
  const Settling settling = settling_of(points, recurrence).value();
  EXPECT_EQ(settling.period, 1);
  EXPECT_NEAR(std::abs(settling.multiplier), 0.8, 1e-6);
  EXPECT_LT(length(difference(settling.limit, rest)), 1e-6);
}

}  // namespace
}  // namespace gearfilm::two_freedoms

// Branches of maps whose folds, flips and doubled periods are known in closed form, and those of the dry pair.
#include "orbits/continuation.hpp"

#include <cmath>
#include <numbers>

#include "orbits/dry_branch.hpp"
#include "orbits/dry_orbit.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// One step of a map with its derivatives.
struct Step {
  Motion image;
  Monodromy by_motion;
  Motion by_parameter;
  double approach = 1.0;
};

/// The map that repeats one step as often as the order says, by the chain rule.
BranchMap repeated(Step (*step)(const Motion&, double)) {
  return [step](const BranchState& at, int order) {
    MapValue value;
    value.by_motion = Monodromy::Identity(2, 2);
    Motion x = at.motion;
    for (int n = 0; n < order; ++n) {
      const Step one = step(x, at.parameter);
      value.by_parameter = to_motion(one.by_motion * to_vector(value.by_parameter) + to_vector(one.by_parameter));
      value.by_motion = one.by_motion * value.by_motion;
      value.least_approach = std::min(value.least_approach, one.approach);
      x = one.image;
      value.states.push_back(x);
    }
    return value;
  };
}

struct Found {
  int branch;
  int order;
  PointKind kind;
  BranchPoint point;
};

struct Followed {
  std::vector<Branch> branches;
  std::vector<Found> points;

  std::vector<Found> of(PointKind kind, int branch) const {
    std::vector<Found> chosen;
    for (const Found& found : points) {
      if (found.kind == kind && found.branch == branch) chosen.push_back(found);
    }
    return chosen;
  }
};

Followed follow(const BranchMap& map, const BranchState& start, bool upwards, const ContinuationOptions& options) {
  Followed result;
  result.branches = follow_branches(map, 1, start, upwards, options,
                                    [&](const Branch& branch, PointKind kind, const BranchPoint& point) {
                                      result.points.push_back({branch.number, branch.order, kind, point});
                                    });
  return result;
}

// Bifurcations are located to 1e-6 of the branch's length, where tests change linearly.
constexpr double located = 2e-6;

// x' = x + lambda - x^2, y' = y/2: x = +-sqrt(lambda), a fold at 0; the multiplier 1 - 2x is -1 at x = 1, lambda = 1.
TEST(Continuation, passes_the_fold_of_a_quadratic_map) {
  const BranchMap map = repeated([](const Motion& x, double lambda) {
    return Step{{x.H0() + lambda - x.H0() * x.H0(), 0.5 * x.V0()},
                Monodromy{{1.0 - 2.0 * x.H0(), 0.0}, {0.0, 0.5}},
                {1.0, 0.0},
                1.0};
  });
  const Followed found = follow(map, {{0.71, 0.0}, 0.5}, false, {.lowest = -1.0, .highest = 0.5});
  const std::vector<Found> folds = found.of(PointKind::fold, 1);
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_NEAR(folds[0].point.state.motion.H0(), 0.0, located);
  EXPECT_NEAR(folds[0].point.state.parameter, 0.0, located);
  EXPECT_TRUE(found.of(PointKind::flip, 1).empty());
  for (const Found& at : found.points) {
    EXPECT_NEAR(at.point.state.parameter, at.point.state.motion.H0() * at.point.state.motion.H0(), 1e-8);
    if (at.kind == PointKind::regular) {
      EXPECT_EQ(at.point.stable(), at.point.state.motion.H0() > 0.0);
    }
  }
  ASSERT_EQ(found.branches.size(), 1u);
  EXPECT_EQ(found.branches[0].end, BranchEnd::at_bound);
  EXPECT_NEAR(found.branches[0].last.motion.H0(), -std::sqrt(0.5), 1e-8);
}

// The logistic map r x (1 - x) beside a coordinate that decays: a flip at r = 3, x = 2/3; the orbit of period 2 is
// x = (r + 1 +- sqrt((r - 3) (r + 1)))/(2 r), and flips at r = 1 + sqrt(6).
TEST(Continuation, follows_the_doubled_period_of_the_logistic_map) {
  const BranchMap map = repeated([](const Motion& x, double r) {
    return Step{{r * x.H0() * (1.0 - x.H0()), -0.3 * x.V0() + x.H0()},
                Monodromy{{r * (1.0 - 2.0 * x.H0()), 0.0}, {1.0, -0.3}},
                {x.H0() * (1.0 - x.H0()), 0.0},
                1.0};
  });
  const Followed found = follow(map, {{0.6, 0.4}, 2.5}, true, {.lowest = 2.5, .highest = 3.5, .largest_order = 4});
  const std::vector<Found> first = found.of(PointKind::flip, 1), second = found.of(PointKind::flip, 2);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_NEAR(first[0].point.state.parameter, 3.0, located);
  EXPECT_NEAR(first[0].point.state.motion.H0(), 2.0 / 3.0, located);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NEAR(second[0].point.state.parameter, 1.0 + std::sqrt(6.0), 10 * located);
  for (const Found& at : found.of(PointKind::regular, 2)) {
    const double r = at.point.state.parameter, x = at.point.state.motion.H0();
    EXPECT_EQ(at.order, 2);
    EXPECT_NEAR(std::abs(2.0 * r * x - r - 1.0), std::sqrt((r - 3.0) * (r + 1.0)), 1e-6);
    EXPECT_EQ(at.point.stable(), r < 1.0 + std::sqrt(6.0));
  }
  ASSERT_EQ(found.branches.size(), 3u);
  EXPECT_EQ(found.branches[1].parent, 1);
  EXPECT_EQ(found.branches[2].order, 4);
  EXPECT_NEAR(found.branches[2].born.value().parameter, second[0].point.state.parameter, 0.0);
}

// With r = 3.2 - lambda^2 the fixed point flips at lambda = +-sqrt(0.2): one branch of period 2 joins both flips.
TEST(Continuation, a_branch_of_doubled_period_ends_where_it_meets_the_other_flip) {
  const BranchMap map = repeated([](const Motion& x, double lambda) {
    const double r = 3.2 - lambda * lambda;
    return Step{{r * x.H0() * (1.0 - x.H0()), 0.2 * x.V0()},
                Monodromy{{r * (1.0 - 2.0 * x.H0()), 0.0}, {0.0, 0.2}},
                {-2.0 * lambda * x.H0() * (1.0 - x.H0()), 0.0},
                1.0};
  });
  const Followed found = follow(map, {{0.54, 0.0}, -1.0}, true, {.lowest = -1.0, .highest = 1.0, .largest_order = 2});
  const std::vector<Found> flips = found.of(PointKind::flip, 1);
  ASSERT_EQ(flips.size(), 2u);
  EXPECT_NEAR(flips[0].point.state.parameter, -std::sqrt(0.2), located);
  EXPECT_NEAR(flips[1].point.state.parameter, std::sqrt(0.2), located);
  ASSERT_EQ(found.branches.size(), 2u) << "the branch is not followed again from its other end";
  EXPECT_EQ(found.branches[1].end, BranchEnd::at_flip);
  EXPECT_NEAR(found.branches[1].last.parameter, std::sqrt(0.2), 0.1);
  EXPECT_TRUE(found.of(PointKind::fold, 2).empty());
}

// A rotation by 1 rad that grows by the factor lambda about the point (0.3 lambda, 0): the pair of multipliers passes
// the unit circle at 1. The same pair as real numbers, lambda and 1/2, is no Neimark-Sacker bifurcation at lambda = 2.
TEST(Continuation, a_complex_pair_passes_the_unit_circle) {
  const BranchMap rotation = repeated([](const Motion& x, double lambda) {
    const double c = lambda * std::cos(1.0), s = lambda * std::sin(1.0), X = x.H0() - 0.3 * lambda;
    return Step{{0.3 * lambda + c * X - s * x.V0(), s * X + c * x.V0()},
                Monodromy{{c, -s}, {s, c}},
                {0.3 - 0.3 * c + std::cos(1.0) * X - std::sin(1.0) * x.V0(),
                 -0.3 * s + std::sin(1.0) * X + std::cos(1.0) * x.V0()},
                lambda - 0.8};
  });
  const Followed found = follow(rotation, {{0.15, 0.0}, 0.5}, true, {.lowest = 0.5, .highest = 1.5});
  ASSERT_EQ(found.of(PointKind::neimark_sacker, 1).size(), 1u);
  EXPECT_NEAR(found.of(PointKind::neimark_sacker, 1)[0].point.state.parameter, 1.0, located);
  ASSERT_EQ(found.of(PointKind::grazing, 1).size(), 1u);
  EXPECT_NEAR(found.of(PointKind::grazing, 1)[0].point.state.parameter, 0.8, located);
  const BranchMap saddle = repeated([](const Motion& x, double lambda) {
    return Step{{lambda * x.H0(), 0.5 * x.V0()}, Monodromy{{lambda, 0.0}, {0.0, 0.5}}, {x.H0(), 0.0}, 1.0};
  });
  const Followed real = follow(saddle, {{0.0, 0.0}, 1.5}, true, {.lowest = 1.5, .highest = 2.5});
  EXPECT_TRUE(real.of(PointKind::neimark_sacker, 1).empty());
  EXPECT_EQ(real.branches[0].end, BranchEnd::at_bound);
}

// The circle x^2 + lambda^2 = 1 as fixed points of x' = x + (1 - x^2 - lambda^2)/4: a branch that comes back.
TEST(Continuation, a_closed_branch_is_followed_once) {
  const BranchMap map = repeated([](const Motion& x, double lambda) {
    return Step{{x.H0() + 0.25 * (1.0 - x.H0() * x.H0() - lambda * lambda), 0.5 * x.V0()},
                Monodromy{{1.0 - 0.5 * x.H0(), 0.0}, {0.0, 0.5}},
                {-0.5 * lambda, 0.0},
                1.0};
  });
  const Followed found = follow(map, {{1.0, 0.0}, 0.0}, true, {.lowest = -2.0, .highest = 2.0});
  EXPECT_EQ(found.branches[0].end, BranchEnd::closed);
  const std::vector<Found> folds = found.of(PointKind::fold, 1);
  ASSERT_EQ(folds.size(), 2u);
  EXPECT_NEAR(folds[0].point.state.parameter, 1.0, located);
  EXPECT_NEAR(folds[1].point.state.parameter, -1.0, located);
}

// A map without a value for lambda > 0.3.
TEST(Continuation, a_branch_that_is_lost_says_where) {
  const BranchMap map = repeated([](const Motion& x, double lambda) {
    if (lambda > 0.3) throw SolveError("no value");
    return Step{{0.5 * x.H0() + lambda, 0.5 * x.V0()}, Monodromy{{0.5, 0.0}, {0.0, 0.5}}, {1.0, 0.0}, 1.0};
  });
  const Followed found = follow(map, {{0.0, 0.0}, 0.0}, true, {.lowest = -1.0, .highest = 1.0});
  EXPECT_EQ(found.branches[0].end, BranchEnd::lost);
  EXPECT_NEAR(found.branches[0].last.parameter, 0.3, 1e-5);
  EXPECT_THROW(follow(map, {{0.0, 0.0}, 0.5}, true, {.lowest = -1.0, .highest = 1.0}), SolveError);
}

MeshAt pair_at(const std::string& key, const Settings& settings = {}) {
  return [=](double value) { return mesh_after_leaving(table3_case(with(settings, {{key, format_value(value)}}))); };
}

// Derivatives of the flow against differences of marches: 1e-10 in each of some hundred steps, over differences of
// 1e-5.
TEST(DryFlow, derivatives_agree_with_marches) {
  for (const std::string key : {"pinion.speed_rpm", "pinion.torque", "gear.equivalent_mass"}) {
    for (const Settings& settings : {Settings{}, with(bending(), relieved())}) {
      const MeshAt mesh_at = pair_at(key, settings);
      const double value = table3_case().parameters.real(key), unit = 0.1 * value, zeta = 0.008;
      const Motion start{-1.2, 0.4};
      const MapValue flow = dry_branch_map(mesh_at, zeta, unit)({start, value}, 2);
      const auto march = [&](const Motion& from, double at) {
        const MeshModel mesh = mesh_at(at);
        DryMarch dry(
            mesh, 1.0, [](const StepRecord&, const std::vector<ActiveContact>&) {}, dry_damping(mesh, zeta));
        dry.start(from);
        dry.run(2.0 * mesh.path.mesh_period());
        return dry.motion();
      };
      const double d = 1e-5;
      const Motion H =
          difference(march({start.H0() + d, start.V0()}, value), march({start.H0() - d, start.V0()}, value));
      const Motion V =
          difference(march({start.H0(), start.V0() + d}, value), march({start.H0(), start.V0() - d}, value));
      const Motion p = difference(march(start, value + d * unit), march(start, value - d * unit));
      EXPECT_LT(length(difference(flow.image(), march(start, value))), 1e-7) << key;
      EXPECT_NEAR(flow.by_motion(0, 0), H.H0() / (2.0 * d), 1e-3);
      EXPECT_NEAR(flow.by_motion(1, 0), H.V0() / (2.0 * d), 1e-3);
      EXPECT_NEAR(flow.by_motion(0, 1), V.H0() / (2.0 * d), 1e-3);
      EXPECT_NEAR(flow.by_motion(1, 1), V.V0() / (2.0 * d), 1e-3);
      EXPECT_NEAR(flow.by_parameter.H0() * unit, p.H0() / (2.0 * d), 1e-3) << key;
      EXPECT_NEAR(flow.by_parameter.V0() * unit, p.V0() / (2.0 * d), 1e-3) << key;
    }
  }
}

Followed follow_dry(double from, double to, int largest_order) {
  const MeshAt mesh_at = pair_at("pinion.speed_rpm");
  ContinuationOptions options{
      .lowest = std::min(from, to), .highest = std::max(from, to), .largest_order = largest_order};
  options.corrector.unit = 0.1 * (options.highest - options.lowest);
  const BranchState start{find_dry_orbit(mesh_at(from), typical_film_damping).start, from};
  return follow(dry_branch_map(mesh_at, typical_film_damping, options.corrector.unit), start, to > from, options);
}

// Speeds from shooting at one speed after the other, with multipliers by differences: to 10 rpm.
TEST(DryBranch, flips_of_the_case_study_where_the_mesh_is_twice_as_fast_as_the_pair) {
  const Followed found = follow_dry(28000.0, 19000.0, 2);
  const std::vector<Found> flips = found.of(PointKind::flip, 1);
  ASSERT_EQ(flips.size(), 2u);
  EXPECT_NEAR(flips[0].point.state.parameter, 26434.0, 10.0);
  EXPECT_NEAR(flips[1].point.state.parameter, 21062.0, 10.0);
  for (const Found& at : found.of(PointKind::regular, 1)) {
    const double speed = at.point.state.parameter;
    EXPECT_EQ(at.point.stable(), speed < flips[1].point.state.parameter || speed > flips[0].point.state.parameter);
  }
  // Supercritical at 26434: the doubled period is stable where the simple one is not; subcritical at 21062.
  EXPECT_TRUE(found.of(PointKind::regular, 2).front().point.stable());
  EXPECT_FALSE(found.of(PointKind::regular, 3).front().point.stable());
  ASSERT_EQ(found.of(PointKind::flip, 2).size(), 1u);
  EXPECT_NEAR(found.of(PointKind::flip, 2)[0].point.state.parameter, 21500.0, 250.0);
  EXPECT_EQ(found.of(PointKind::grazing, 2).size(), 1u);
}

// Two stable states below the fold, one above it; each repeats in a march.
TEST(DryBranch, hysteresis_of_the_case_study_begins_at_a_fold) {
  const Followed from_below = follow_dry(8000.0, 12000.0, 1), from_above = follow_dry(12000.0, 8000.0, 1);
  const std::vector<Found> folds = from_below.of(PointKind::fold, 1);
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_TRUE(from_above.of(PointKind::fold, 1).empty());
  const MeshAt mesh_at = pair_at("pinion.speed_rpm");
  const double speed = folds[0].point.state.parameter;
  const auto near_the_fold = [&](double at) {
    return follow_dry_orbit(mesh_at(at), typical_film_damping, folds[0].point.state.motion);
  };
  const auto beside = near_the_fold(speed - 5.0);
  ASSERT_TRUE(beside);
  EXPECT_LT(length(difference(beside->start, folds[0].point.state.motion)), 0.1);
  const auto beyond = near_the_fold(speed + 5.0);
  EXPECT_TRUE(!beyond || length(difference(beyond->start, folds[0].point.state.motion)) > 0.1);
  EXPECT_GT(from_above.branches[0].last.motion.V0(), 2.0);
  EXPECT_EQ(from_above.branches[0].end, BranchEnd::at_bound);
}

}  // namespace
}  // namespace gearfilm

// Other starts of a search for the periodic state, where the first leads to none. The searches themselves are stood in
// for: what is held is which are made, with what, and what comes of them.
#include "orbits/orbit_starts.hpp"

#include "gearfilm/error.hpp"
#include "input/case_with_parameter.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// Searches that find nothing but at some speeds, and the state there.
class Searches {
public:
  explicit Searches(double found_at) : found_at_(found_at) {}

  FoundOrbit from_starts() {
    return find_orbit_from_starts(
        problem, problems_at_speeds(pair),
        {[this](const auto& from) { return own(from); }, [this](const auto& at) { return beside(at); }});
  }

  CaseInput pair = table3_case();
  OrbitProblem problem = orbit_problem(pair);
  bool finds_from_beside = true;
  std::vector<std::optional<StateBeside>> starts;
  std::vector<double> speeds;  ///< over that of the pair, of searches beside
  const Motion there{{-1.5}, {0.7}};

private:
  FoundOrbit own(const std::optional<StateBeside>& from) {
    starts.push_back(from);
    if (!from || !finds_from_beside) throw NoPeriodicState("start ", starts.size(), " leads to none");
    FoundOrbit found;
    found.own.orbit.start.motion = from->motion;
    return found;
  }

  DescribedOrbit beside(const OrbitProblem& at_speed) {
    EXPECT_FALSE(at_speed.search.with_multipliers);
    speeds.push_back(problem.mesh.path.mesh_period() * problem.mesh.scales.time /
                     (at_speed.mesh.path.mesh_period() * at_speed.mesh.scales.time));
    if (std::abs(speeds.back() - found_at_) > 1e-9) throw SolveError("none here");
    DescribedOrbit found;
    found.orbit.start.motion = there;
    return found;
  }

  double found_at_;
};

TEST(OrbitStarts, a_state_at_another_speed_is_the_next) {
  Searches searches(0.98);
  const FoundOrbit found = searches.from_starts();
  ASSERT_EQ(searches.speeds.size(), 2U);
  EXPECT_NEAR(searches.speeds[0], 1.02, 1e-12);
  ASSERT_EQ(searches.starts.size(), 2U);
  EXPECT_FALSE(searches.starts[0]);
  EXPECT_EQ(searches.starts[1]->speed_ratio, 0.98);
  EXPECT_EQ(searches.starts[1]->why, "start 1 leads to none");
  // The same displacement in metres, and the same velocity in metres a second.
  const CaseInput slower =
      case_with_parameter(searches.pair, "pinion.speed_rpm", 0.98 * searches.pair.parameters.real("pinion.speed_rpm"));
  const Scales &from = slower.scales, &to = searches.pair.scales;
  EXPECT_NEAR(found.own.orbit.start.motion.H0() * to.thickness, searches.there.H0() * from.thickness,
              1e-12 * to.thickness);
  EXPECT_NEAR(found.own.orbit.start.motion.V0() * to.thickness / to.time,
              searches.there.V0() * from.thickness / from.time, 1e-12 * to.thickness / to.time);
  EXPECT_NE(from.time, to.time);
}

TEST(OrbitStarts, the_first_failure_is_told_where_no_speed_has_a_state) {
  Searches searches(1.5);
  try {
    searches.from_starts();
    FAIL();
  } catch (const NoPeriodicState& error) {
    EXPECT_STREQ(error.what(), "start 1 leads to none");
  }
  EXPECT_EQ(searches.speeds.size(), 2U);
  EXPECT_EQ(searches.starts.size(), 1U);
}

TEST(OrbitStarts, end_with_the_state_beside) {
  Searches searches(1.02);
  searches.finds_from_beside = false;
  EXPECT_THROW(searches.from_starts(), NoPeriodicState);
  EXPECT_EQ(searches.speeds.size(), 1U);
  EXPECT_EQ(searches.starts.size(), 2U);
}

TEST(OrbitStarts, are_no_others_where_one_is_given) {
  Searches given(1.02), in_balance(1.02);
  given.problem.search.start = Motion{{-1.0}, {0.0}};
  in_balance.problem.mesh.inertia = 0.0;
  for (Searches* searches : {&given, &in_balance}) {
    EXPECT_THROW(searches->from_starts(), NoPeriodicState);
    EXPECT_TRUE(searches->speeds.empty());
  }
}

}  // namespace
}  // namespace gearfilm

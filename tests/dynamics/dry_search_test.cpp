// Searches of the dry pair's periodic motion where its force has kinks, and what they say where there is none.
#include <gmock/gmock.h>

#include "dynamics/dry_flow.hpp"
#include "orbits/dry_following.hpp"
#include "orbits/dry_orbit.hpp"
#include "orbits/dry_settling.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// The pair of docs/tutorial.md on bending teeth with parabolic relief of both tips.
Settings tutorial_pair(const std::string& speed) {
  return {{"pinion.teeth", "25"},
          {"pinion.outer_radius", "33.75e-3"},
          {"pinion.crowning", "40e-6"},
          {"pinion.speed_rpm", speed},
          {"pinion.torque", "150"},
          {"pinion.tip_relief", "20e-6"},
          {"pinion.tip_relief_length", "3e-3"},
          {"pinion.tip_relief_shape", "parabolic"},
          {"wheel.teeth", "40"},
          {"wheel.outer_radius", "52.5e-3"},
          {"wheel.crowning", "40e-6"},
          {"wheel.tip_relief", "20e-6"},
          {"wheel.tip_relief_length", "3e-3"},
          {"wheel.tip_relief_shape", "parabolic"},
          {"gear.module", "2.5e-3"},
          {"gear.centre_distance", "81.25e-3"},
          {"gear.equivalent_mass", "0.1236"},
          {"gear.tooth_compliance", "weber"},
          {"lubricant.viscosity", "0.030"},
          {"lubricant.pressure_viscosity", "2e-8"},
          {"start.place", "after_leaving"}};
}

MeshModel case_study(const std::string& speed) {
  return mesh_of(table3_case({{"start.place", "after_leaving"}, {"pinion.speed_rpm", speed}}));
}

Motion rest(const MeshModel& mesh) { return DryMarch::balance(mesh, DryForce(mesh), 0.0); }

TEST(DrySearch, state_of_bending_teeth_is_that_of_a_long_march) {
  for (const char* speed : {"15150", "19000"}) {
    const MeshModel mesh = mesh_of(table3_case(tutorial_pair(speed)));
    const DryOrbit orbit = find_dry_orbit(mesh, typical_film_damping);
    ASSERT_LT(largest_modulus(multipliers(orbit.monodromy)), 1.0);
    Motion end = rest(mesh);
    DryFlow::march(mesh, typical_film_damping, end, 600, [&](const DryPeriod& period) { end = period.motion; });
    // The march, integrated to 1e-10, misses up to 1e-8 a mesh period where gaps close, and keeps 0.97 of it into the
    // next: 3e-7 together. A swing has died away to 1e-8 of itself.
    EXPECT_LT(length(difference(end, orbit.start)), 1e-6) << speed << " rpm";
  }
}

TEST(DrySearch, message_says_after_how_many_periods_the_pair_repeats) {
  // At 24000 rpm the case study doubles its period; no state repeats after three.
  const MeshModel mesh = case_study("24000");
  const DryWatch none;
  const DrySettling settling = settle_for_long({mesh, typical_film_damping, none}, {rest(mesh).H0() - 0.5, 0.0});
  EXPECT_EQ(settling.repeats_after, 2);
  EXPECT_TRUE(settling.leads_to(2));
  EXPECT_TRUE(settling.leads_to(4));
  EXPECT_FALSE(settling.leads_to(1));
  EXPECT_THAT(what_it_does(settling, mesh),
              testing::HasSubstr("repeats after 2 mesh period(s); try -periodic_order 2"));
  const DryOrbit order_one = find_dry_orbit(mesh, typical_film_damping);
  EXPECT_GT(largest_modulus(multipliers(order_one.monodromy)), 1.0);
}

TEST(DrySearch, unstable_state_is_near_the_middle_of_a_doubled_one) {
  const MeshModel mesh = case_study("24000");
  const DryWatch none;
  const DryMap map(mesh, typical_film_damping, none);
  const DrySettling settling = settle_for_long(map, {rest(mesh).H0() - 0.5, 0.0});
  const Motion expected = find_dry_orbit(mesh, typical_film_damping).start;
  double nearest = HUGE_VAL;
  for (const Motion& guess : near_unstable(settling, 1)) {
    const auto found = shoot(map, guess);
    if (found) nearest = std::min(nearest, length(difference(*found, expected)));
  }
  EXPECT_LT(nearest, 1e-7);  // both to 1e-9 in P(x) - x
}

TEST(DrySearch, a_branch_is_followed_past_another_and_not_beyond_its_end) {
  // Between 8900 and 10404 rpm the case study has a quiet state and one that loses contact; the quiet one ends there.
  const MeshAt mesh_at = [](double speed) { return case_study(std::to_string(speed)); };
  const DryWatch none;
  const DryOrbit quiet = find_dry_orbit(mesh_at(9500), typical_film_damping);
  const auto near_end = follow_dry_branch(mesh_at, 1, typical_film_damping, {quiet.start, 9500.0}, 10380.0, none);
  ASSERT_TRUE(near_end);
  EXPECT_LT(find_dry_orbit(mesh_at(9500), typical_film_damping).largest_integral,
            follow_dry_orbit(mesh_at(10380), typical_film_damping, *near_end)->largest_integral);
  EXPECT_FALSE(follow_dry_branch(mesh_at, 1, typical_film_damping, {quiet.start, 9500.0}, 10500.0, none));
}

TEST(DrySearch, a_watch_ends_it) {
  struct Enough {};
  int marched = 0;
  const DryWatch watch = [&](int mesh_periods) {
    if ((marched += mesh_periods) > 5) throw Enough{};
  };
  EXPECT_THROW(find_dry_orbit(case_study("15000"), typical_film_damping, watch), Enough);
}

}  // namespace
}  // namespace gearfilm

// Bodies without inertia: at every moment in balance with the forces of all contacts.
#include "pair_case.hpp"

namespace gearfilm {
namespace {

Settings without_inertia() {
  return {{"motion", "quasi_static"}, {"film.discretisation", "fitted"}, {"grid.nx", "65"}, {"grid.ny", "33"},
          {"time.dt", "0.05"},        {"start.place", "after_leaving"}};
}

double total_force(const StepRecord& record) {
  double sum = 0.0;
  for (const ContactRecord& contact : record.contacts) sum += contact.figures["force"];
  return sum;
}

TEST(PairInBalance, bodies_are_in_balance_through_entering_and_leaving) {
  RecordedMarch march(table3_case(without_inertia()));
  march.start();
  march.run(1.2 * march.path().mesh_period());
  std::size_t fewest = 9, most = 0;
  for (const StepRecord& record : march.records()) {
    EXPECT_NEAR(total_force(record) / march.static_force(), 1.0, 1e-5) << record.T;
    fewest = std::min(fewest, record.contacts.size());
    most = std::max(most, record.contacts.size());
  }
  EXPECT_EQ(fewest, 1U);
  EXPECT_EQ(most, 2U);
}

// Films forget within a mesh period, and bodies have nothing to remember.
TEST(PairInBalance, pair_repeats_after_one_mesh_period) {
  RecordedMarch march(table3_case(without_inertia()));
  const double period = march.path().mesh_period();
  march.start();
  march.run(period);
  const double once = march.motion().H0;
  march.run(2.0 * period);
  EXPECT_NEAR(march.motion().H0, once, 1e-4);
}

TEST(PairInBalance, steps_need_not_follow_a_swing_that_is_not_there) {
  const auto step_of = [](const std::string& motion) {
    return input_case("barbieri2013.yaml", {{"motion", motion}, {"pinion.speed_rpm", "500"}}).numerics.steps.dT;
  };
  EXPECT_GT(step_of("quasi_static"), 2.0 * step_of("dynamic"));
}

}  // namespace
}  // namespace gearfilm

// Friction in the motion of the pair, and losses of mesh periods.
#include <gtest/gtest.h>

#include "dynamics/friction_force.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

const Settings coulomb = {{"friction.law", "coulomb"}, {"friction.coefficient", "0.05"}, {"friction.in_motion", "yes"}};

ContactRecord sliding_contact(double xi, double friction) {
  ContactRecord contact;
  contact.position = xi;
  contact.quantities["friction_force"] = friction;
  return contact;
}

TEST(FrictionInMotion, shares_of_the_inertias_are_those_of_the_gears) {
  const MeshModel given = mesh_of(table3_case(coulomb));
  EXPECT_NEAR(given.friction_couples_dynamics->pinion + given.friction_couples_dynamics->wheel, 1.0, 1e-12);
  EXPECT_FALSE(mesh_of(table3_case()).friction_couples_dynamics);
}

// Arms of 39.5 and 60.6 mm over base radii, at the pitch point: A = -F_s R_x(0) (g_1/R_b1 + g_2 tau ...) = -0.48 F_s.
TEST(FrictionInMotion, sliding_beyond_the_pitch_point_takes_force_off_the_contacts) {
  const MeshModel mesh = mesh_of(table3_case(coulomb));
  const double newton = 1.0 / mesh.scales.force(1.0);
  EXPECT_NEAR(friction_on_motion(mesh, {sliding_contact(1e-6, 100.0)})[0] / (-100.0 * newton), 0.48, 0.01);
  EXPECT_GT(friction_on_motion(mesh, {sliding_contact(-2e-3, -100.0)})[0], 0.0);
  // Two contacts on either side of it nearly cancel.
  EXPECT_LT(std::abs(friction_on_motion(mesh, {sliding_contact(4e-3, 100.0), sliding_contact(-4e-3, -100.0)})[0]),
            20.0 * newton);
}

// Of shafts that do not twist and gears that stay in their bearings, the inertias of either side turn together.
TEST(FrictionInMotion, in_a_drive_train_works_on_all_that_turns_and_across_the_line_of_action) {
  const MeshModel mesh = mesh_after_leaving(input_case("electric_reducer.yaml", coulomb));
  const LineOfAction& line = mesh.path.line();
  const auto mass = [](double inertia, double radius) { return inertia / (radius * radius); };
  const double pinion = mass(0.03 + 1.8e-4, line.base_radius_pinion());
  const double wheel = mass(0.15 + 1e-2, line.base_radius_wheel());
  MeshModel alone = mesh;
  alone.train.reset();
  alone.friction_couples_dynamics = InertiaShares{wheel / (pinion + wheel), pinion / (pinion + wheel)};
  const std::vector<ContactRecord> contacts = {sliding_contact(2e-3, 100.0), sliding_contact(-1e-3, -50.0)};
  const Eigen::VectorXd in_train = friction_on_motion(mesh, contacts);
  EXPECT_NEAR(in_train[0] / friction_on_motion(alone, contacts)[0], 1.0, 1e-9);
  EXPECT_EQ(mesh.freedoms(), 7);  // 5, and a way of each gear along the flanks
  EXPECT_GT(in_train.tail(6).norm(), 0.1 * std::abs(in_train[0]));
}

// Away from the pitch point, where Coulomb's friction changes sign at once.
TEST(FrictionInMotion, is_of_second_order_in_time) {
  std::vector<double> ends;
  for (const char* dT : {"0.1", "0.05", "0.025"}) {
    Settings settings = with(with(after_leaving(), coulomb), {{"start.place", "position"},
                                                              {"start.position", "0.5e-3"},
                                                              {"time.dt", dT},
                                                              {"time.newton_tolerance", "1e-10"}});
    settings.erase("start.H0");
    settings.erase("start.V0");
    RecordedMarch march(table3_case(settings));
    march.start();
    march.run(0.28 * march.path().mesh_period());
    ends.push_back(march.motion().H0());
  }
  const double order = std::log2((ends[0] - ends[1]) / (ends[1] - ends[2]));
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 2.5);
}

TEST(FrictionInMotion, balances_the_mean_force_of_a_quick_decay) {
  RecordedMarch with_friction(table3_case(with(after_leaving(), coulomb)));
  RecordedMarch without(table3_case(after_leaving()));
  for (RecordedMarch* march : {&with_friction, &without}) {
    march->start();
    march->run(0.1 * march->path().mesh_period());
  }
  // One contact before the pitch point: friction presses the gears together, which sink deeper.
  EXPECT_LT(with_friction.motion().V0(), without.motion().V0());
}

TEST(Losses, mean_power_is_that_of_the_steps) {
  Settings settings = with(after_leaving(), coulomb);
  RecordedMarch march(table3_case(settings));
  march.start();
  march.run(march.path().mesh_period());
  MarchStatistics statistics(march.path().mesh_period(), march.static_force());
  double energy = 0.0, last = 0.0;
  for (const StepRecord& record : march.records()) {
    statistics.add(record, available_models(march.mesh(), true));
    energy += 0.5 * (last + record.power_sliding()) * record.dT;
    last = record.power_sliding();
  }
  EXPECT_NEAR(statistics.periods().at(0)["power_sliding"].value(), energy / march.path().mesh_period(), 1e-9 * energy);
  EXPECT_GT(energy, 0.0);
}

}  // namespace
}  // namespace gearfilm

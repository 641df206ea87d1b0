// Modes, shares and damping of drive trains against closed forms and tests/reference/drivetrain.json.
#include <numbers>

#include "algebra/dense.hpp"
#include "table3.hpp"
#include "train_reference.hpp"

namespace gearfilm::trains {
namespace {

using std::numbers::pi;

constexpr double round_off = 1e-12;

TEST(Train, of_two_gears_has_their_natural_frequency) {
  Train train({gear_node(0, false), gear_node(1, false)});
  mesh_gears(train);
  const RelativeMotion relative = relative_motion(train);
  const double k = stiffness_of("weber_bores"), r1 = train.node(0).radius, r2 = train.node(1).radius;
  const double mass = 1.0 / (r1 * r1 / train.node(0).inertia + r2 * r2 / train.node(1).inertia);
  EXPECT_NEAR(relative.projected(train.mass())(0, 0), mass, round_off * mass);
  EXPECT_NEAR((train.contacts() * relative.motions)(0, 0), 1.0, round_off);
  const std::vector<TrainMode> modes = train_modes(train, relative, std::array{k});
  ASSERT_EQ(modes.size(), 1U);
  const double frequency = std::sqrt(k / mass) / (2.0 * pi);
  EXPECT_NEAR(modes[0].frequency(), frequency, round_off * frequency);
  EXPECT_NEAR(modes[0].mesh_share, 1.0, round_off);
  EXPECT_NEAR(frequency, 3727.1867, 1e-7 * 3727.0);
}

TEST(Train, on_bearings_has_the_frequencies_and_shares_of_the_reference) {
  const double tolerance = reference().at("table3").at("tol");
  for (const auto& [teeth, by_stiffness] : reference().at("table3").at("f").items()) {
    for (const auto& [stiffness, expected] : by_stiffness.items()) {
      const std::vector<TrainMode> modes = modes_of(pair_on_bearings(std::stod(stiffness)), {stiffness_of(teeth)});
      expect_frequencies(modes, expected.at("f6"), tolerance);
      double shares = 0.0;
      for (std::size_t n = 0; n < modes.size(); ++n) {
        const double share = expected.at("mesh_share")[n + 1];
        EXPECT_NEAR(modes[n].mesh_share, share, 1e-5 * share + 1e-9);
        shares += modes[n].mesh_share;
      }
      EXPECT_NEAR(shares, 1.0, 1e-9);
    }
  }
}

TEST(Train, on_unequal_bearings_has_modes_across_the_line_of_action) {
  Train train({gear_node(0, true), gear_node(1, true)});
  train.add_bearing(0, bearing_of(1e8, 3e8));
  train.add_bearing(1, bearing_of(2e8, 4e8));
  mesh_gears(train);
  for (const auto& [teeth, expected] : reference().at("table3").at("aniso_x1e8_y3e8__x2e8_y4e8").items()) {
    expect_frequencies(modes_of(train, {stiffness_of(teeth)}), expected, 1e-6);
  }
}

// f_n (1 - k/k_b) of two equal supports, to first order.
TEST(Train, on_stiff_bearings_is_the_pair_on_rigid_ones) {
  const double f_n = 3727.1867;
  for (const auto& [stiffness, frequency] : {std::pair{1e12, 3726.428}, std::pair{1e14, 3727.179}}) {
    const double k = stiffness_of("weber_bores"), found = modes_of(pair_on_bearings(stiffness), {k})[0].frequency();
    EXPECT_NEAR(found, frequency, 5e-4);
    EXPECT_NEAR(found, f_n * (1.0 - k / stiffness), 1e-6 * f_n);
  }
}

TEST(Train, on_isotropic_bearings_does_not_depend_on_the_pressure_angle) {
  const double k = stiffness_of("weber_bores");
  const std::vector<TrainMode> modes = modes_of(pair_on_bearings(1e8), {k});
  for (const double degrees : {10.0, 40.0}) {
    const std::vector<TrainMode> others = modes_of(pair_on_bearings(1e8, degrees * pi / 180.0), {k});
    for (std::size_t n = 0; n < modes.size(); ++n) EXPECT_NEAR(others[n].rate / modes[n].rate, 1.0, 1e-9);
  }
}

// Unequal bearings that turn with the line of action.
TEST(Train, does_not_depend_on_the_axes_of_its_bearings) {
  const double k = stiffness_of("weber_bores");
  std::vector<double> first;
  for (const double angle : {0.0, 0.3, 1.1}) {
    const Eigen::Matrix2d turn{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}};
    Train train({gear_node(0, true), gear_node(1, true)});
    const Eigen::Matrix2d own{{1e8, 2e7}, {2e7, 3e8}};
    for (const std::size_t gear : {0, 1}) train.add_bearing(gear, {.stiffness = turn * own * turn.transpose()});
    mesh_gears(train, 0.4 + angle);
    const std::vector<TrainMode> modes = modes_of(train, {k});
    for (std::size_t n = 0; n < modes.size(); ++n) {
      if (angle == 0.0) first.push_back(modes[n].rate);
      EXPECT_NEAR(modes[n].rate / first[n], 1.0, 1e-9);
    }
  }
}

TEST(Train, with_motor_and_load_has_the_frequencies_of_the_reference) {
  const double k = stiffness_of("weber_bores");
  expect_frequencies(modes_of(line_with_motor_and_load(false), {k}), reference().at("train_torsion").at("f"), 1e-6);
  Train train = line_with_motor_and_load(true);
  train.add_bearing(1, bearing_of(1e8, 3e8));
  train.add_bearing(2, bearing_of(2e8, 4e8));
  const std::vector<TrainMode> modes = modes_of(train, {k});
  expect_frequencies(modes, reference().at("train8").at("f"), 1e-6);
  for (const TrainMode& mode : modes) {
    double shares = mode.mesh_share;
    for (const double share : mode.element_shares) shares += share;
    EXPECT_NEAR(shares, 1.0, 1e-8);
    EXPECT_NEAR(mode.shape.dot(train.mass() * mode.shape), 1.0, 1e-9);
  }
}

TEST(Train, turns_freely_as_a_whole_unless_a_speed_is_imposed) {
  const double k = stiffness_of("weber_bores");
  for (const bool fixed : {false, true}) {
    Train train = line_with_motor_and_load(true, fixed);
    train.add_bearing(1, bearing_of(1e8, 1e8));
    train.add_bearing(2, bearing_of(1e8, 1e8));
    const RelativeMotion relative = relative_motion(train);
    EXPECT_EQ(relative.rigid.size() > 0, !fixed);
    const Eigen::MatrixXd K = train.stiffness() + k * train.contacts().transpose() * train.contacts();
    const SymmetricEigenPairs all = symmetric_eigen_pairs(K, train.mass());
    EXPECT_EQ((all.values.array().abs() < 1.0).count(), fixed ? 0 : 1);
    EXPECT_EQ(static_cast<Eigen::Index>(modes_of(train, {k}).size()), train.freedoms() - (fixed ? 0 : 1));
  }
}

// h first, and inverse to each other; the rotation of the whole has no part in either.
TEST(RelativeMotion, leaves_the_rotation_of_the_whole_out) {
  Train train = line_with_motor_and_load(true);
  train.add_bearing(1, bearing_of(1e8, 3e8));
  train.add_bearing(2, bearing_of(2e8, 4e8));
  const RelativeMotion relative = relative_motion(train);
  const Eigen::Index count = train.freedoms() - 1;
  EXPECT_TRUE((relative.coordinates * relative.motions).isIdentity(1e-10));
  EXPECT_TRUE(relative.coordinates.row(0).isApprox(train.contacts().row(0)));
  EXPECT_TRUE((train.contacts() * relative.motions).isApprox(Eigen::RowVectorXd::Unit(count, 0), 1e-10));
  EXPECT_LT((relative.motions.transpose() * train.mass() * relative.rigid).norm(), 1e-12);
  EXPECT_LT((train.contacts() * relative.rigid).norm(), 1e-12);
  EXPECT_LT((train.stiffness() * relative.rigid).norm(), 1e-7 * train.stiffness().norm());
}

TEST(RelativeMotion, names_the_parts_that_hang_on_nothing) {
  const auto message_of = [](const Train& train) { return table3::input_error_of([&] { relative_motion(train); }); };
  for (const bool fixed : {false, true}) {
    Train train({{.name = "coupling", .inertia = 0.1, .fixed = false},
                 {.name = "fan", .inertia = 0.2},
                 {.name = "motor", .inertia = 0.2, .fixed = fixed},
                 gear_node(0, false),
                 gear_node(1, false)});
    train.add_shaft(0, 1, {.stiffness = 1e4});
    train.add_shaft(2, 3, {.stiffness = 1e4});
    mesh_gears(train);
    EXPECT_NE(message_of(train).find("hang on nothing: coupling, fan;"), std::string::npos) << message_of(train);
  }
  Train unheld({gear_node(0, false), gear_node(1, false), {.name = "disc", .inertia = 0.1, .mass = 3.0}});
  unheld.add_shaft(1, 2, {.stiffness = 1e4});
  mesh_gears(unheld);
  EXPECT_NE(message_of(unheld).find("hang on nothing: disc;"), std::string::npos) << message_of(unheld);
  Train unheld_gear({gear_node(0, true), gear_node(1, false)});
  mesh_gears(unheld_gear);
  EXPECT_NE(message_of(unheld_gear).find("pinion"), std::string::npos);
}

TEST(TrainDamping, by_the_ratio_of_an_element_is_that_ratio_where_it_is_the_mode) {
  Train train({gear_node(0, true), gear_node(1, true)});
  for (const std::size_t gear : {0, 1}) {
    train.add_bearing(gear, {.stiffness = Eigen::Vector2d(1e8, 1e8).asDiagonal(), .damping_ratio = 0.02});
  }
  mesh_gears(train);
  const DampedTrain damped = damped_train(train, {.stiffness = stiffness_of("weber_bores")}, 0.0);
  ASSERT_EQ(damped.references.size(), 2U);
  EXPECT_EQ(damped.references[0].element, "bearing pinion");
  // Across the line of action a gear moves on its bearing alone.
  for (const TrainMode& mode : damped.modes) {
    if (mode.mesh_share > 1e-12) continue;
    EXPECT_NEAR(damped.damping_ratio(mode), 0.02, 1e-9);
  }
}

TEST(TrainDamping, of_modes_leaves_the_mesh_and_the_rotation_of_the_whole_alone) {
  const Train train = line_with_motor_and_load(false);
  const DampedTrain damped = damped_train(train, {.stiffness = stiffness_of("weber_bores")}, 0.03);
  for (const TrainMode& mode : damped.modes) {
    EXPECT_NEAR(damped.damping_ratio(mode), 0.03 * (1.0 - mode.mesh_share), 1e-12);
  }
  EXPECT_LT((damped.damping * damped.relative.rigid).norm(), 1e-10 * damped.damping.norm());
}

TEST(TrainDamping, beside_the_contact_is_that_of_the_pair) {
  Train train({gear_node(0, false), gear_node(1, false)});
  mesh_gears(train);
  const double k = stiffness_of("weber_bores"), mass = case_study().at("m_ge");
  const DampedTrain damped = damped_train(train, {.stiffness = k, .damping = 2.0 * 0.05 * std::sqrt(k * mass)}, 0.0);
  EXPECT_NEAR(damped.damping_ratio(damped.modes[0]), 0.05, 1e-9);
}

}  // namespace
}  // namespace gearfilm::trains

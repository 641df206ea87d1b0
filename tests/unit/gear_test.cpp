// Geometry and kinematics along the line of action.
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "gear/line_of_action.hpp"
#include "table3.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;
using table3::expect_derived;
using table3::expect_input_error_naming;
using table3::round_off;

// Two equal gears of 60 teeth whose tip circles give the contact ratio asked for.
SpurGearPair symmetric_pair(double contact_ratio) {
  SpurGearPair pair{.pinion = {.teeth = 60},
                    .wheel = {.teeth = 60},
                    .module_length = 2e-3,
                    .pressure_angle = 20.0 * pi / 180.0,
                    .centre_distance = 120e-3,
                    .face_width = 20e-3};
  const double base_radius = 60e-3 * std::cos(pair.pressure_angle);
  const double base_pitch = 2.0 * pi * base_radius / 60.0;
  const double tip_tangent = base_radius * std::tan(pair.pressure_angle) + contact_ratio * base_pitch / 2.0;
  pair.pinion.outer_radius = pair.wheel.outer_radius = std::hypot(base_radius, tip_tangent);
  return pair;
}

TEST(LineOfAction, reproduces_table3_geometry) {
  const LineOfAction line(table3::gear_pair());
  expect_derived("working_pressure_angle_deg", line.working_pressure_angle() * 180.0 / pi);
  expect_derived("R_x", line.radius_x(0.0));
  expect_derived("R_y", line.radius_y());
  expect_derived("contact_ratio", line.contact_ratio());
  expect_derived("f_m", mesh_frequency(table3::gear_pair(), table3::pinion_speed));
}

TEST(LineOfAction, reproduces_table3_entry_and_exit) {
  // From an independent program: entry, exit, and the place of the elder contact when the next one enters.
  const LineOfAction line(table3::gear_pair());
  constexpr double printed = 0.6e-6;  // half a unit of the last digit, and a little
  EXPECT_NEAR(line.entry(), -5.639e-3, printed);
  EXPECT_NEAR(line.exit(), 5.747e-3, printed);
  EXPECT_NEAR(line.entry() + line.base_pitch(), 3.217e-3, printed);
}

TEST(LineOfAction, loss_factor_is_ohlendorfs_up_to_two_contacts) {
  const LineOfAction line(table3::gear_pair());
  const double eps_1 = line.exit() / line.base_pitch(), eps_2 = -line.entry() / line.base_pitch(), u = 43.0 / 28.0;
  const double ohlendorf = pi * (u + 1.0) / (28.0 * u) * (1.0 - eps_1 - eps_2 + eps_1 * eps_1 + eps_2 * eps_2);
  EXPECT_NEAR(line.loss_factor(), ohlendorf, round_off);
  EXPECT_NEAR(line.loss_factor(), 0.1002022, 1e-6);  // from an independent program
}

TEST(LineOfAction, loss_factor_of_three_contacts_is_the_mean_of_their_sliding) {
  const LineOfAction line(symmetric_pair(2.4));
  constexpr int steps = 20000;
  double sum = 0.0;
  for (int n = 0; n < steps; ++n) {
    const double xi = line.entry() + (line.exit() - line.entry()) * (n + 0.5) / steps;
    sum += std::abs(xi) / static_cast<double>(line.contact_positions(xi).size());
  }
  sum *= (line.exit() - line.entry()) / steps;
  EXPECT_NEAR(line.loss_factor(), (1.0 + line.speed_ratio()) * sum / (line.base_radius_pinion() * line.base_pitch()),
              1e-5);
}

TEST(LineOfAction, pitch_radius_has_its_closed_form) {
  // R_x* = R_b1 tan(alpha')/(1+tau)
  const LineOfAction line(table3::gear_pair());
  const double expected =
      line.base_radius_pinion() * std::tan(line.working_pressure_angle()) / (1.0 + line.speed_ratio());
  EXPECT_NEAR(line.radius_x(0.0), expected, round_off * expected);
}

TEST(LineOfAction, flank_radii_add_up_to_the_distance_of_the_base_tangent_points) {
  const LineOfAction line(table3::gear_pair());
  const double distance = 111e-3 * std::sin(line.working_pressure_angle());
  for (const double xi : {line.entry(), -1e-3, 0.0, 2e-3, line.exit()}) {
    EXPECT_NEAR(line.radius_pinion(xi) + line.radius_wheel(xi), distance, round_off * distance);
  }
}

TEST(LineOfAction, velocities_are_those_of_the_two_flanks) {
  const LineOfAction line(table3::gear_pair());
  const double omega = table3::pinion_speed;
  for (const double xi : {line.entry(), -1e-3, 2e-3, line.exit()}) {
    const double u1 = omega * line.radius_pinion(xi);
    const double u2 = omega * line.speed_ratio() * line.radius_wheel(xi);
    EXPECT_NEAR(line.entrainment_velocity(xi, omega), (u1 + u2) / 2.0, round_off * u1);
    EXPECT_NEAR(line.sliding_velocity(xi, omega), u1 - u2, round_off * u1);
  }
}

TEST(LineOfAction, pitch_point_rolls_without_sliding) {
  EXPECT_EQ(LineOfAction(table3::gear_pair()).sliding_velocity(0.0, table3::pinion_speed), 0.0);
}

TEST(LineOfAction, contact_travels_one_base_pitch_in_a_mesh_period) {
  const LineOfAction line(table3::gear_pair());
  const double period = 1.0 / mesh_frequency(table3::gear_pair(), table3::pinion_speed);
  EXPECT_NEAR(line.travel_velocity(table3::pinion_speed) * period, line.base_pitch(), round_off * line.base_pitch());
}

TEST(LineOfAction, exchanging_the_gears_mirrors_the_path_of_contact) {
  SpurGearPair exchanged = table3::gear_pair();
  std::swap(exchanged.pinion, exchanged.wheel);
  const LineOfAction line(table3::gear_pair());
  const LineOfAction mirror(exchanged);
  EXPECT_NEAR(mirror.entry(), -line.exit(), round_off * line.exit());
  EXPECT_NEAR(mirror.exit(), -line.entry(), round_off * line.exit());
  EXPECT_NEAR(mirror.base_pitch(), line.base_pitch(), round_off * line.base_pitch());
  EXPECT_NEAR(mirror.radius_x(-1e-3), line.radius_x(1e-3), round_off * line.radius_x(1e-3));
}

TEST(LineOfAction, crownings_of_both_gears_add_as_curvatures) {
  SpurGearPair pair = table3::gear_pair();
  const double both = LineOfAction(pair).radius_y();
  pair.wheel.crowning = 0.0;
  const double one = LineOfAction(pair).radius_y();
  EXPECT_NEAR(one, 2.0 * both, round_off * one);
  EXPECT_NEAR(one, 20e-3 * 20e-3 / (8.0 * 0.131e-3), round_off * one);
  pair.pinion.crowning = 0.0;
  EXPECT_EQ(LineOfAction(pair).radius_y(), std::numeric_limits<double>::infinity());
}

TEST(LineOfAction, equivalent_mass_is_that_of_two_masses_on_the_base_circles_in_series) {
  const LineOfAction line(table3::gear_pair());
  const double m1 = 0.5;
  const double m2 = 2.0;
  const double I1 = m1 * line.base_radius_pinion() * line.base_radius_pinion();
  const double I2 = m2 * line.base_radius_wheel() * line.base_radius_wheel();
  EXPECT_NEAR(equivalent_mass(line, I1, I2), m1 * m2 / (m1 + m2), round_off);
}

class ContactPositions : public testing::TestWithParam<double> {};

TEST_P(ContactPositions, are_all_places_one_base_pitch_apart_within_the_path) {
  const LineOfAction line(symmetric_pair(GetParam()));
  ASSERT_NEAR(line.contact_ratio(), GetParam(), 1e-12);
  const double pitch = line.base_pitch();
  constexpr int samples = 997;
  int contacts = 0;
  for (int i = 0; i < samples; ++i) {
    const double xi = line.entry() + (i + 0.5) / samples * pitch;
    const auto positions = line.contact_positions(xi);
    ASSERT_FALSE(positions.empty());
    EXPECT_NEAR(positions.back(), xi, round_off * pitch);
    for (std::size_t k = 0; k + 1 < positions.size(); ++k) {
      EXPECT_NEAR(positions[k] - positions[k + 1], pitch, 1e-12 * pitch);
    }
    EXPECT_LE(positions.front(), line.exit());
    EXPECT_GT(positions.front() + pitch, line.exit());
    contacts += static_cast<int>(positions.size());
  }
  // The contact ratio is the mean number of contacts; the sampling is off by at most one sample.
  EXPECT_NEAR(static_cast<double>(contacts) / samples, GetParam(), 1.0 / samples);
}

INSTANTIATE_TEST_SUITE_P(ratios_from_1_to_3, ContactPositions, testing::Values(1.05, 1.2857, 1.8, 2.0, 2.3, 2.9, 3.0));

TEST(LineOfAction, contact_positions_do_not_depend_on_the_contact_they_are_asked_for) {
  const LineOfAction line(symmetric_pair(2.3));
  const auto expected = line.contact_positions(0.1e-3);
  ASSERT_EQ(expected.size(), 3U);
  for (const int shift : {-7, -1, 1, 2, 40}) {
    const auto positions = line.contact_positions(0.1e-3 + shift * line.base_pitch());
    ASSERT_EQ(positions.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(positions[k], expected[k], 1e-15);
  }
}

TEST(LineOfAction, contact_at_an_end_of_the_path_counts_despite_round_off) {
  const LineOfAction line(table3::gear_pair());
  const auto entering = line.contact_positions(line.entry() + line.base_pitch());
  ASSERT_EQ(entering.size(), 2U);
  EXPECT_GE(entering.back(), line.entry());
  EXPECT_NEAR(entering.back(), line.entry(), 1e-15);
  const auto leaving = line.contact_positions(line.exit() - line.base_pitch());
  ASSERT_EQ(leaving.size(), 2U);
  EXPECT_LE(leaving.front(), line.exit());
  EXPECT_EQ(line.contact_positions(line.exit() - 1.001 * line.base_pitch()).size(), 2U);
  EXPECT_EQ(line.contact_positions(line.exit() - 0.999 * line.base_pitch()).size(), 1U);
}

// A change that spoils the Table 3 pair, and the parameter its message has to name.
struct Spoiled {
  const char* parameter;
  void (*spoil)(SpurGearPair&);

  friend void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.parameter; }
};

class WrongGearPair : public testing::TestWithParam<Spoiled> {};

TEST_P(WrongGearPair, is_refused_with_the_name_of_the_parameter) {
  SpurGearPair pair = table3::gear_pair();
  GetParam().spoil(pair);
  expect_input_error_naming(GetParam().parameter, [&] { LineOfAction{pair}; });
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    each_parameter, WrongGearPair,
    testing::Values(Spoiled{"pinion_teeth = 0", [](SpurGearPair& pair) { pair.pinion.teeth = 0; }},
                    Spoiled{"wheel_teeth = -43", [](SpurGearPair& pair) { pair.wheel.teeth = -43; }},
                    Spoiled{"pinion_outer_radius", [](SpurGearPair& pair) { pair.pinion.outer_radius = 0.0; }},
                    Spoiled{"wheel_outer_radius", [](SpurGearPair& pair) { pair.wheel.outer_radius = not_a_number; }},
                    Spoiled{"pinion_crowning", [](SpurGearPair& pair) { pair.pinion.crowning = -1e-6; }},
                    Spoiled{"wheel_crowning", [](SpurGearPair& pair) { pair.wheel.crowning = not_a_number; }},
                    Spoiled{"gear_module", [](SpurGearPair& pair) { pair.module_length = 0.0; }},
                    Spoiled{"gear_pressure_angle_deg = 90", [](SpurGearPair& pair) { pair.pressure_angle = pi / 2.0; }},
                    Spoiled{"gear_centre_distance", [](SpurGearPair& pair) { pair.centre_distance = -1.0; }},
                    Spoiled{"gear_face_width", [](SpurGearPair& pair) { pair.face_width = 0.0; }}));

INSTANTIATE_TEST_SUITE_P(
    geometry_that_cannot_mesh, WrongGearPair,
    testing::Values(
        Spoiled{"gear_centre_distance = 0.1 m", [](SpurGearPair& pair) { pair.centre_distance = 0.1; }},
        Spoiled{"pinion_outer_radius = 0.039 m", [](SpurGearPair& pair) { pair.pinion.outer_radius = 0.039; }},
        Spoiled{"wheel_outer_radius = 0.06 m", [](SpurGearPair& pair) { pair.wheel.outer_radius = 0.06; }},
        Spoiled{"teeth would be pointed", [](SpurGearPair& pair) { pair.module_length = 0.002; }},
        // xi_s below -R_b1 tan(alpha'), and xi_e above R_b2 tan(alpha')
        Spoiled{"reduce wheel_outer_radius", [](SpurGearPair& pair) { pair.wheel.outer_radius = 0.08; }},
        Spoiled{"reduce pinion_outer_radius", [](SpurGearPair& pair) { pair.pinion.outer_radius = 0.07; }}));

TEST(LineOfAction, refuses_a_contact_ratio_below_one) {
  SpurGearPair pair = table3::gear_pair();
  pair.pinion.outer_radius = 45.5e-3;
  pair.wheel.outer_radius = 69.0e-3;
  const std::string message = table3::input_error_of([&] { LineOfAction{pair}; });
  EXPECT_TRUE(message.starts_with("contact ratio 0.")) << message;
  EXPECT_NE(message.find("pinion_outer_radius, wheel_outer_radius"), std::string::npos) << message;
}

TEST(LineOfAction, refuses_a_path_of_contact_without_the_pitch_point) {
  SpurGearPair pair = symmetric_pair(3.0);
  const LineOfAction line(pair);
  // A tip circle through the pitch point ends the path there; a little less, and the pitch point is off it.
  pair.wheel.outer_radius = 0.999 * std::hypot(line.base_radius_wheel(), line.radius_wheel(0.0));
  expect_input_error_naming("enlarge wheel_outer_radius", [&] { LineOfAction{pair}; });
  std::swap(pair.pinion, pair.wheel);
  expect_input_error_naming("enlarge pinion_outer_radius", [&] { LineOfAction{pair}; });
}

}  // namespace
}  // namespace gearfilm

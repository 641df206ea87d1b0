// Shares of the static force along the line of action.
#include "gear/load_sharing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// Table 3: contact ratio 1.286.
LineOfAction table3_line(double outer_radius_wheel = 69.85e-3) {
  return LineOfAction({.pinion = {.teeth = 28, .outer_radius = 46.55e-3, .crowning = 0.131e-3},
                       .wheel = {.teeth = 43, .outer_radius = outer_radius_wheel, .crowning = 0.131e-3},
                       .module_length = 3e-3,
                       .pressure_angle = 20.0 * std::numbers::pi / 180.0,
                       .centre_distance = 111e-3,
                       .face_width = 20e-3});
}

TEST(LoadSharing, steps_are_one_over_the_number_of_contacts) {
  const LineOfAction line = table3_line();
  const LoadSharing share = LoadSharing::step(line);
  ASSERT_EQ(share.pieces().size(), 3u);
  EXPECT_DOUBLE_EQ(share(line.entry()), 0.5);
  EXPECT_DOUBLE_EQ(share(0.0), 1.0);
  EXPECT_DOUBLE_EQ(share(line.exit()), 0.5);
  // At a jump the later piece counts; inside, both sides can be had.
  const double alone_from = line.exit() - line.base_pitch();
  EXPECT_DOUBLE_EQ(share(alone_from), 1.0);
  EXPECT_DOUBLE_EQ(share.pieces()[0](alone_from), 0.5);
}

TEST(LoadSharing, all_contacts_together_carry_the_static_force) {
  const LineOfAction line = table3_line();
  for (const LoadSharing& share : {LoadSharing::step(line), LoadSharing::trapezoid(line, 1.0 / 3.0, 2.0 / 3.0)}) {
    for (int n = 1; n < 200; ++n) {
      double sum = 0.0;
      const double xi = line.exit() - line.base_pitch() * n / 200.0;
      for (double position : line.contact_positions(xi)) sum += share(position);
      EXPECT_NEAR(sum, 1.0, 1e-12) << xi;
    }
  }
}

TEST(LoadSharing, trapezoid_ramps_where_two_contacts_exist) {
  const LineOfAction line = table3_line();
  const LoadSharing share = LoadSharing::trapezoid(line, 0.3, 0.7);
  const double alone_from = line.exit() - line.base_pitch(), alone_to = line.entry() + line.base_pitch();
  EXPECT_DOUBLE_EQ(share(line.entry()), 0.3);
  EXPECT_NEAR(share(0.5 * (line.entry() + alone_from)), 0.5, 1e-12);
  EXPECT_NEAR(share.pieces()[0](alone_from), 0.7, 1e-12);
  EXPECT_DOUBLE_EQ(share(0.0), 1.0);
  EXPECT_NEAR(share(alone_to), 0.7, 1e-12);
  EXPECT_NEAR(share(line.exit()), 0.3, 1e-12);
}

TEST(LoadSharing, table_is_linear_between_its_points) {
  const LineOfAction line = table3_line();
  const LoadSharing share = LoadSharing::table(line, {{-6e-3, 0.4}, {-3e-3, 0.6}, {-3e-3, 1.0}, {6e-3, 1.0}});
  EXPECT_NEAR(share(-4.5e-3), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(share(-3e-3), 1.0);
  EXPECT_DOUBLE_EQ(share(5e-3), 1.0);
}

TEST(LoadSharing, a_jump_takes_a_length_and_nothing_else_changes) {
  const LineOfAction line = table3_line();
  const LoadSharing sudden =
      LoadSharing::table(line, {{-6e-3, 0.4}, {-3e-3, 0.6}, {-3e-3, 1.0}, {0.0, 0.8}, {6e-3, 0.8}});
  const LoadSharing gradual = sudden.with_jumps_over(1e-3);
  ASSERT_EQ(gradual.pieces().size(), 4u);
  EXPECT_EQ(gradual.pieces()[1].jump, true);
  for (std::size_t n : {0u, 2u, 3u}) EXPECT_EQ(gradual.pieces()[n].jump, false) << n;
  const double landing = sudden(-2e-3);
  EXPECT_NEAR(gradual(-3e-3), 0.6, 1e-12);
  EXPECT_NEAR(gradual(-2.5e-3), 0.5 * (0.6 + landing), 1e-12);
  for (double xi : {-5e-3, -3.5e-3, -2e-3, -1e-3, 0.0, 3e-3}) EXPECT_NEAR(gradual(xi), sudden(xi), 1e-12) << xi;
  EXPECT_EQ(LoadSharing::step(line).with_jumps_over(1e-5).pieces().size(), 5u);
  EXPECT_THROW(sudden.with_jumps_over(4e-3), InputError);
}

TEST(LoadSharing, wrong_tables_are_refused) {
  const LineOfAction line = table3_line();
  EXPECT_THROW(LoadSharing::table(line, {{0.0, 1.0}}), InputError);
  EXPECT_THROW(LoadSharing::table(line, {{-6e-3, 1.0}, {5e-3, 1.0}}), InputError);
  EXPECT_THROW(LoadSharing::table(line, {{-6e-3, 1.0}, {6e-3, 0.0}}), InputError);
  EXPECT_THROW(LoadSharing::table(line, {{6e-3, 1.0}, {-6e-3, 1.0}}), InputError);
}

TEST(LoadSharing, trapezoid_needs_a_contact_ratio_below_two) {
  // input/high_contact_ratio.yaml
  SpurGearPair slender{.pinion = {.teeth = 40, .outer_radius = 53.25e-3, .crowning = 0.060e-3},
                       .wheel = {.teeth = 60, .outer_radius = 78.25e-3, .crowning = 0.060e-3},
                       .module_length = 2.5e-3,
                       .pressure_angle = 17.5 * std::numbers::pi / 180.0,
                       .centre_distance = 125e-3,
                       .face_width = 20e-3};
  const LineOfAction line(slender);
  ASSERT_GT(line.contact_ratio(), 2.0);
  EXPECT_THROW(LoadSharing::trapezoid(line, 0.3, 0.7), InputError);
  const LoadSharing share = LoadSharing::step(line);
  EXPECT_DOUBLE_EQ(share(line.entry()), 1.0 / static_cast<double>(line.contact_positions(line.entry() + 1e-6).size()));
}

}  // namespace
}  // namespace gearfilm

// Pairs whose geometry others have published, and teeth that do not fit into each other.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"
#include "gearfilm/error.hpp"
#include "gear/iso_stiffness.hpp"
#include "gear/tooth_profile.hpp"
#include "gear/tooth_space.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;

SpurGear gear(int teeth, double tip_radius, double profile_shift) {
  return {.teeth = teeth,
          .outer_radius = tip_radius,
          .crowning = 10e-6,
          .youngs_modulus = 206e9,
          .poisson_ratio = 0.3,
          .profile_shift = profile_shift};
}

SpurGearPair pair_of(const SpurGear& pinion, const SpurGear& wheel, double module_length, double centre_distance,
                     double face_width) {
  return {.pinion = pinion,
          .wheel = wheel,
          .module_length = module_length,
          .pressure_angle = 20.0 * degree,
          .centre_distance = centre_distance,
          .face_width = face_width};
}

/// FZG C as in the examples of GEARpie.
SpurGearPair fzg_c() {
  return pair_of(gear(16, 41.318e-3, 0.1817), gear(24, 59.272e-3, 0.1715), 4.5e-3, 91.5e-3, 14e-3);
}

/// FZG A: a wheel with a large negative shift.
SpurGearPair fzg_a() { return pair_of(gear(16, 44.385e-3, 0.8635), gear(24, 56.25e-3, -0.5), 4.5e-3, 91.5e-3, 20e-3); }

SpurGearPair twelve_teeth() { return pair_of(gear(12, 22.42e-3, 0.6), gear(24, 39.7e-3, 0.36), 3e-3, 56.5e-3, 20e-3); }

double line_pressure(double force, double width, double radius, double reduced_modulus) {
  const double half_width = hertz_line_half_width(force / width, radius, reduced_modulus);
  return 2.0 * force / (pi * half_width * width);
}

// Printed to the digits that are asked for here. Its loss rests on bending teeth: static_mesh_test.cpp.
TEST(PublishedPairs, fzg_c_by_gearpie) {
  const LineOfAction line(fzg_c());
  const double force = 200.0 / line.base_radius_pinion();
  EXPECT_NEAR(force, 5912.1, 0.05);
  EXPECT_NEAR(1e-6 * line_pressure(force, 14e-3, line.radius_x(0.0), reduced_modulus(206e9, 0.3, 206e9, 0.3)), 1347.3,
              2.0);
  const double AE = line.exit() - line.entry();
  EXPECT_NEAR(1e3 * AE, 19.43, 0.005);
  EXPECT_NEAR(1e3 * (AE - line.base_pitch()), 6.14, 0.01);
  EXPECT_NEAR(1e3 * -line.entry(), 9.68, 0.005);
  EXPECT_NEAR(1e3 * line.base_pitch(), 13.28, 0.006);
}

TEST(PublishedPairs, twelve_and_twenty_four_teeth) {
  const LineOfAction line(twelve_teeth());
  EXPECT_NEAR(line.working_pressure_angle() / degree, 26.0888, 5e-5);
  EXPECT_NEAR(line.contact_ratio(), 1.202, 5e-4);
  EXPECT_NEAR(*tooth_space(twelve_teeth()).implied_backlash, 0.0, 1e-6);
}

TEST(ToothSpace, both_thicknesses_and_the_implied_backlash_fill_the_working_pitch) {
  SpurGearPair pair = fzg_c();
  pair.wheel.profile_shift = 0.1;
  const LineOfAction line(pair);
  const ToothSpace space = tooth_space(pair);
  const double pitch = 2.0 * pi * pair.centre_distance / 40;
  EXPECT_GT(*space.implied_backlash, 0.1e-3);
  EXPECT_NEAR(space.pitch_thickness[0] + space.pitch_thickness[1] +
                  *space.implied_backlash / std::cos(line.working_pressure_angle()),
              pitch, 1e-12);
}

void expect_refused(const SpurGearPair& pair, const std::string& words) {
  const LineOfAction line(pair);
  try {
    check_tooth_space(pair, line);
    FAIL() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(words));
  }
}

TEST(ToothSpace, refuses_what_does_not_fit) {
  SpurGearPair pair = fzg_c();
  check_tooth_space(pair, LineOfAction(pair));
  for (const double backlash : {0.05, 0.01, 0.006}) {
    pair.backlash = backlash;
    expect_refused(pair, "gear_backlash");
  }
  pair = fzg_c();
  pair.pinion.profile_shift = pair.wheel.profile_shift = 1.5;
  expect_refused(pair, "imply a backlash of -0.008");
  pair = fzg_c();
  pair.wheel.root_radius = 51e-3;
  expect_refused(pair, "tips of the pinion dig 0.000818 m into the roots of the wheel");
  pair = fzg_c();
  pair.wheel.bore_radius = 55e-3;
  expect_refused(pair, "wheel_bore_radius");
  pair = fzg_c();
  pair.pinion.root_radius = 36e-3;
  expect_refused(pair, "pinion_root_radius");
  pair = fzg_c();
  pair.centre_distance = 110e-3;
  EXPECT_THROW(LineOfAction{pair}, InputError);
}

// The fillet joins the outline of an involute without a step, and the tooth grows thicker towards its root.
TEST(ToothProfile, undercut_teeth_end_their_involute_where_the_rack_cuts_it) {
  const SpurGearPair pair = fzg_a();
  const ToothProfile wheel(pair.wheel, pair, -0.5, "wheel"), pinion(pair.pinion, pair, 0.8635, "pinion");
  EXPECT_FALSE(pinion.undercut());
  ASSERT_TRUE(wheel.undercut());
  const double above = wheel.form_radius() - wheel.base_radius();
  EXPECT_GT(above, 0.0);
  EXPECT_LT(above, 16e-6);  // where the rack's path itself ends
  const LineOfAction line(pair);
  const double rho = line.radius_wheel(line.exit());
  EXPECT_GT(std::hypot(wheel.base_radius(), rho), wheel.form_radius());
  const std::vector<OutlinePoint> outline = wheel.outline_to(rho);
  for (std::size_t n = 1; n < outline.size(); ++n) {
    EXPECT_GT(outline[n].y, outline[n - 1].y);
    EXPECT_LT(std::abs(outline[n].x - outline[n - 1].x), 60e-6) << n;
  }
  SpurGear deep = pair.wheel;
  deep.teeth = 7;
  EXPECT_THROW(ToothProfile(deep, pair, -0.5, "deep").load_at(0.5e-3), InputError);
}

TEST(IsoStiffness, of_other_materials_counts_by_their_modulus) {
  SpurGearPair pair = fzg_c();
  const double steel = iso_stiffness(pair, 1.5).single;
  pair.wheel.youngs_modulus = 2.8e9;
  EXPECT_NEAR(iso_stiffness(pair, 1.5).single / steel, 2.0 * 2.8 / (206.0 + 2.8), 1e-12);
  pair.pinion.youngs_modulus = 2.8e9;
  EXPECT_NEAR(iso_stiffness(pair, 1.5).single / steel, 2.8 / 206.0, 1e-12);
}

}  // namespace
}  // namespace gearfilm

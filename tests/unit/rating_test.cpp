// Ratings against public examples: ISO/TR 6336-30, example 1, as a program on GitHub quotes it (gfsReboucas/Drivetrain)
// and the FZG pair C14 as another one rates it (cfernandesFEUP/GEARpie).
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "damage_reference.hpp"
#include "gear/line_of_action.hpp"
#include "rating/micropitting.hpp"
#include "rating/pitting.hpp"
#include "rating/rating_model.hpp"
#include "rating/root.hpp"
#include "rating/scuffing.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

constexpr double printed = 1e-4;  // relative: digits of the examples

void expect_relative(double found, const std::string& name, double unit = 1.0, double tolerance = printed) {
  EXPECT_NEAR(found / unit, damage_number(name), tolerance * damage_number(name)) << name;
}

constexpr double torque = 200.0;  // of C14 [N m]
constexpr double reduced_modulus = 206e9 / 0.91;

SpurGearPair fzg_c14() {
  SpurGearPair pair;
  pair.module_length = 4.5e-3;
  pair.pressure_angle = 20.0 * pi / 180.0;
  pair.centre_distance = 91.5e-3;
  pair.face_width = 14e-3;
  pair.pinion = {.teeth = 16,
                 .outer_radius = 4.5e-3 * (8.0 + 1.0 + 0.1817),
                 .youngs_modulus = 206e9,
                 .poisson_ratio = 0.3,
                 .profile_shift = 0.1817,
                 .hob_tip_radius = 0.375 * 4.5e-3};
  pair.wheel = {.teeth = 24,
                .outer_radius = 4.5e-3 * (12.0 + 1.0 + 0.1715),
                .youngs_modulus = 206e9,
                .poisson_ratio = 0.3,
                .profile_shift = 0.1715,
                .hob_tip_radius = 0.375 * 4.5e-3};
  return pair;
}

double force() { return torque / (0.5 * 16 * 4.5e-3 * std::cos(20.0 * pi / 180.0)); }

/// Hertz pressure of the whole force as a line load [Pa].
double line_pressure(const LineOfAction& line, double xi) {
  return std::sqrt(force() / 14e-3 * reduced_modulus / (2.0 * pi * line.radius_x(xi)));
}

TEST(Pitting, of_c14_is_that_of_the_public_rating) {
  const NominalContactStress nominal = nominal_contact_stress(fzg_c14(), torque);
  expect_relative(nominal.zone_factor, "fzg_c14_200Nm_ZH");
  expect_relative(nominal.ratio_factor, "fzg_c14_200Nm_Zeps");
  expect_relative(nominal.elasticity_factor, "iso6336_30_ex1_ZE", 1e3);
  expect_relative(nominal.stress, "fzg_c14_200Nm_sigma_H0", 1e6);
  expect_relative(nominal.pinion_factor, "fzg_c14_200Nm_ZB");
}

TEST(Pitting, factors_are_ratios_of_hertz_pressures) {
  const SpurGearPair pair = fzg_c14();
  const LineOfAction line(pair);
  const NominalContactStress nominal = nominal_contact_stress(pair, torque);
  const double pitch = line_pressure(line, 0.0), inner = line_pressure(line, line.exit() - line.base_pitch());
  EXPECT_NEAR(nominal.stress / nominal.ratio_factor, pitch, 1e-10 * pitch);
  EXPECT_NEAR(nominal.pinion_factor, inner / pitch, 1e-10);
  expect_relative(pitch, "fzg_c14_pitch_hertz_MPa", 1e6);
  expect_relative(inner, "fzg_c14_hertz_at_B_MPa", 1e6);
  EXPECT_EQ(nominal.wheel_factor, 1.0);  // the outer point is less loaded than the pitch point
}

TEST(Pitting, factors_of_limits_are_those_of_the_first_example) {
  constexpr double limit = 1500e6, torque_1 = 9e3;
  const double d_1 = 17 * 8.0 / std::cos(15.8 * pi / 180.0), velocity = 1e-3 * pi * d_1 * 360.0 / 60.0;
  EXPECT_NEAR(2e3 * torque_1 / d_1, 127352.0, 1.0);
  const auto& expected = damage_reference().at("iso6336_30_ex1_ZL_Zv").at("value");
  EXPECT_NEAR(lubricant_factor(320e-6, limit), expected[0].get<double>(), printed);
  EXPECT_NEAR(velocity_factor(velocity, limit), expected[1].get<double>(), printed);
  const double transverse = std::atan(std::tan(20.0 * pi / 180.0) / std::cos(15.8 * pi / 180.0));
  const double base_1 = d_1 * std::cos(transverse), base_2 = base_1 * 103 / 17,
               working = std::acos(0.5 * (base_1 + base_2) / 500.0);
  const double rho_1 = 0.5 * base_1 * std::tan(working), rho_2 = 0.5 * base_2 * std::tan(working);
  expect_relative(roughness_factor(6e-6, 1e-3 * rho_1 * rho_2 / (rho_1 + rho_2), limit), "iso6336_30_ex1_ZR");
  expect_relative(contact_life_factor(1.08e9), "ZNT_1.08e9");
}

TEST(LifeFactors, go_through_their_corners) {
  EXPECT_EQ(contact_life_factor(1e4), 1.6);
  EXPECT_NEAR(contact_life_factor(1e5), 1.6, 1e-12);
  EXPECT_NEAR(contact_life_factor(5e7), 1.0, 1e-12);
  EXPECT_NEAR(contact_life_factor(1e12), 0.85, 1e-12);
  EXPECT_NEAR(root_life_factor(3e6), 1.0, 1e-12);
  EXPECT_NEAR(root_life_factor(1e3), 2.5, 1e-12);
  EXPECT_NEAR(root_life_factor(1e10), 0.85, 1e-12);
  // The slopes of ISO 6336-6: 13.22 of flanks, 8.74 of roots.
  EXPECT_NEAR(std::log(10.0) / std::log(contact_life_factor(1e6) / contact_life_factor(1e7)), 13.22, 5e-3);
  EXPECT_NEAR(std::log(10.0) / std::log(root_life_factor(1e4) / root_life_factor(1e5)), 8.74, 5e-3);
}

TEST(Root, of_c14_is_that_of_the_public_rating) {
  const SpurGearPair pair = fzg_c14();
  const LineOfAction line(pair);
  const ToothRoot pinion(pair.pinion, pair, 0.1817), wheel(pair.wheel, pair, 0.1715);
  // The outer points of single contact: the mate has just come in, or is about to leave.
  const RootFactors first = pinion.factors(line.radius_pinion(line.entry() + line.base_pitch())),
                    second = wheel.factors(line.radius_wheel(line.exit() - line.base_pitch()));
  expect_relative(first.form, "fzg_c14_YF1");
  expect_relative(first.stress_correction, "fzg_c14_YS1");
  expect_relative(second.form, "fzg_c14_YF2");
  expect_relative(second.stress_correction, "fzg_c14_YS2");
  expect_relative(pinion.root_thickness(), "fzg_c14_sFn_over_m_1");
  expect_relative(wheel.root_thickness(), "fzg_c14_sFn_over_m_2");
}

TEST(Root, is_stressed_more_by_loads_nearer_the_tip) {
  const SpurGearPair pair = fzg_c14();
  const LineOfAction line(pair);
  const ToothRoot pinion(pair.pinion, pair, 0.1817);
  double before = 0.0;
  for (double xi = line.entry(); xi < line.exit(); xi += 1e-3) {
    const double stress = pinion.stress(1e3, line.radius_pinion(xi));
    EXPECT_GT(stress, before);
    before = stress;
  }
  EXPECT_NEAR(pinion.stress(2e3, 0.012), 2.0 * pinion.stress(1e3, 0.012), 1e-3);
}

TEST(RatingModel, has_the_stresses_of_its_formulas) {
  const SpurGearPair pair = fzg_c14();
  RatingModel model{
      .pair = pair, .line = LineOfAction(pair), .reduced_modulus = reduced_modulus, .pinion_speed = 1500.0 * pi / 30.0};
  EXPECT_NEAR(model.contact_stress(force(), 0.0), line_pressure(model.line, 0.0), 1e-3);
  EXPECT_EQ(model.root_stress(0, force(), 0.0), 0.0);   // without a limit
  EXPECT_EQ(model.film_ratio(force(), 0.0, 3.0), 0.0);  // without roughness
  EXPECT_EQ(model.contact_stress(0.0, 0.0), 0.0);
  model.roots = {ToothRoot(pair.pinion, pair, 0.1817), ToothRoot(pair.wheel, pair, 0.1715)};
  // sigma_F0 = F_t/(b m) Y_F Y_S at the outer point of single contact.
  const double outer = model.line.entry() + model.line.base_pitch();
  const double nominal =
      2.0 * torque / (16 * 4.5e-3) / (14e-3 * 4.5e-3) * damage_number("fzg_c14_YF1") * damage_number("fzg_c14_YS1");
  EXPECT_NEAR(model.root_stress(0, force(), outer), nominal, 1e-3 * nominal);
  model.limits = {.contact = 1500e6, .root = 1000e6, .cycles = 3e6};
  EXPECT_NEAR(model.permissible_root_stress(0), 1000e6, 1.0);
  EXPECT_NEAR(model.permissible_root_stress(1) / 1000e6, root_life_factor(2e6), 1e-12);
  const double bare = model.permissible_contact_stress();
  model.limits.viscosity_40 = 320e-6;
  EXPECT_NEAR(model.permissible_contact_stress() / bare, lubricant_factor(320e-6, 1500e6), 1e-12);
}

TEST(Friction, loss_factor_of_c14_is_the_printed_one) {
  expect_relative(LineOfAction(fzg_c14()).loss_factor(), "fzg_c14_HV");
}

/// Flash temperature of C14 at 1500 rpm where half the load is carried in double contact.
double flash_of_c14(const LineOfAction& line, double xi) {
  constexpr double friction = 0.0449, effusivity = 13e3, speed = 1500.0 * pi / 30.0;
  const bool single = xi > line.exit() - line.base_pitch() && xi < line.entry() + line.base_pitch();
  const double load = (single ? 1.0 : 0.5) * force() / 14e-3;
  const double half_width = std::sqrt(8.0 * load * line.radius_x(xi) / (pi * reduced_modulus));
  return flash_temperature(friction * load, half_width, {speed * line.radius_pinion(xi), effusivity},
                           {speed * line.speed_ratio() * line.radius_wheel(xi), effusivity});
}

TEST(Scuffing, flash_temperatures_of_c14_are_those_of_the_reference) {
  const LineOfAction line(fzg_c14());
  const double at_A = flash_of_c14(line, line.entry());
  double largest = at_A, sum = 0.0;
  constexpr int steps = 20000;
  for (int n = 0; n < steps; ++n) {
    const double flash = flash_of_c14(line, line.entry() + (line.exit() - line.entry()) * (n + 0.5) / steps);
    largest = std::max(largest, flash);
    sum += flash / steps;
  }
  expect_relative(at_A, "fzg_c14_flash_at_A_K");
  expect_relative(largest, "fzg_c14_flash_max_K");
  expect_relative(sum, "fzg_c14_flash_mean_over_path_K");
}

TEST(Scuffing, safeties_are_one_at_their_limits) {
  EXPECT_DOUBLE_EQ(flash_safety(500.0, 360.0, 500.0), 1.0);
  EXPECT_DOUBLE_EQ(flash_safety(500.0, 360.0, 430.0), 2.0);
  EXPECT_DOUBLE_EQ(integral_temperature(380.0, 20.0), 410.0);
  EXPECT_DOUBLE_EQ(integral_safety(273.15 + 240.0, 273.15 + 120.0), 2.0);
}

TEST(Micropitting, films_of_c14_are_those_of_the_reference) {
  const LineOfAction line(fzg_c14());
  constexpr double speed = 1500.0 * pi / 30.0;
  const auto film = [&](double xi, double share) {
    const double u = 0.5 * speed * (line.radius_pinion(xi) + line.speed_ratio() * line.radius_wheel(xi));
    return micropitting_film({line.radius_x(xi), u, share * force() / 14e-3}, {13.28e-3, 20.47e-9, reduced_modulus});
  };
  expect_relative(film(line.entry(), 0.5), "fzg_c14_h_ts22_min_um", 1e-6);
  expect_relative(film(0.0, 1.0), "fzg_c14_h_ts22_at_pitch_um", 1e-6);
}

}  // namespace
}  // namespace gearfilm

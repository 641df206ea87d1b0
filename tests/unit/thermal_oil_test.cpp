// The oil's viscosity over temperature, and formulas for friction.
#include "lubricant/thermal_oil.hpp"

#include <gtest/gtest.h>

#include "friction_reference.hpp"
#include "contact/friction_formulas.hpp"
#include "contact/hertz.hpp"
#include "gear/line_of_action.hpp"
#include "table3.hpp"

namespace gearfilm {
namespace {

const ThermalOil warm{.temperature_viscosity = 0.04};

TEST(ThermalOil, viscosity_falls_with_temperature_at_the_given_rate) {
  for (const AnyViscosityLaw& law : {AnyViscosityLaw(Roelands{}), AnyViscosityLaw(Barus{})}) {
    const Lubricant oil{.viscosity = 0.04, .pressure_viscosity = 2.2e-8, .viscosity_law = law};
    EXPECT_NEAR(log_relative_viscosity(oil, warm, 0.0, warm.temperature).derivative, -0.04, 1e-12);
  }
}

TEST(ThermalOil, density_falls_with_temperature_at_the_given_rate) {
  const ThermalOil expanding{.expansion = 7e-4};
  EXPECT_DOUBLE_EQ(density_factor({.viscosity = 0.04}, expanding, 1e9, 373.15), 1.0 - 7e-3);
}

TEST(ThermalOil, conductivity_grows_with_pressure) {
  EXPECT_DOUBLE_EQ(warm.conductivity_at(0.0), 0.137);
  EXPECT_NEAR(warm.conductivity_at(1e9), 0.137 * (1.0 + 1.72 / 1.54), 1e-12);
}

TEST(FrictionFormulas, xu_and_kahraman_as_the_reference_has_them) {
  const LineOfAction line(table3::gear_pair());
  const ContactSolids pitch{.radius_x = line.radius_x(0.0),
                            .radius_y = line.radius_y(),
                            .reduced_modulus = reduced_modulus(206e9, 0.3, 206e9, 0.3)};
  for (const auto& at : friction_case::reference().at("positions")) {
    const double u_m = at.at("u_m"), slide_ratio = at.at("u_s").get<double>() / u_m;
    const double pressure = hertz_contact(pitch, at.at("force")).pressure;  // of the pitch point's radius there
    const double expected = at.at("mu_xu_kahraman");
    EXPECT_NEAR(xu_kahraman_friction(pressure, slide_ratio, u_m, 0.04, line.radius_x(at.at("xi")), 0.4e-6), expected,
                1e-3 * expected);
  }
}

TEST(FrictionFormulas, schlenk_blok_and_the_thermal_factors) {
  const LineOfAction line(table3::gear_pair());
  const double force = table3::pinion_torque / line.base_radius_pinion();
  EXPECT_NEAR(schlenk_friction(force / 0.02, 2.0 * line.entrainment_velocity(0.0, table3::pinion_speed),
                               line.radius_x(0.0), 0.04, 0.4e-6),
              friction_case::reference().at("mesh_average").at("schlenk_mu").get<double>(), 1e-4);
  EXPECT_NEAR(blok_flash_temperature(1000.0, 25.0, 16.0, 13000.0, 2e-4), 1.11 * 1000.0 / (13000.0 * 0.02), 1e-9);
  EXPECT_NEAR(thermal_loading(0.04, 0.04, 29.744, 0.137), 10.33, 0.01);
  EXPECT_NEAR(murch_wilson_factor(10.33), 0.48, 0.005);
  EXPECT_NEAR(gupta_factor(10.33, 2.86 / 226.0, 0.0), 0.29, 0.006);
  EXPECT_EQ(gupta_factor(1e4, 0.1, 1.0), 0.0);
}

}  // namespace
}  // namespace gearfilm

// Oils by their free volume: squalane against values worked out apart, derivatives, and the way on into the glass.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "gearfilm/lubricant/thermal_oil.hpp"

namespace gearfilm {
namespace {

// Table 1 of doi 10.3389/fmtec.2022.1029860; temperature as in input/squalane.yaml.
Lubricant squalane() {
  return {.viscosity = 0.0276,
          .viscosity_law = ViscosityLaw::doolittle,
          .density_law = DensityLaw::tait,
          .temperature = 298.0,
          .reference_temperature = 298.0,
          .tait = {.modulus = 1.312e9, .slope = 11.74, .softening = 5.457e-3, .expansion = 8.123e-4},
          .doolittle = {.factor = 5.258, .occupied = 0.6633, .expansion = -5.66e-4}};
}

// A fit to squalane by least squares, as an interpolant.
Lubricant by_yasutomi() {
  return {.viscosity = 0.0276,
          .viscosity_law = ViscosityLaw::yasutomi,
          .temperature = 298.0,
          .yasutomi = {.glass_temperature = 194.679,
                       .A1 = 652.16,
                       .A2 = 0.05e-9,
                       .b1 = 7.7404e-9,
                       .b2 = -0.5974,
                       .C1 = 16.0159,
                       .C2 = 18.6786}};
}

TEST(FreeVolume, squalane_at_one_temperature) {
  const Lubricant oil = squalane();
  for (const auto& [pressure, viscosity] : {std::pair{0.2e9, 0.897}, {0.5e9, 39.2}, {1e9, 1.00e4}}) {
    EXPECT_NEAR(oil.viscosity * std::exp(log_relative_viscosity(oil, pressure).value) / viscosity, 1.0, 5e-3);
  }
  EXPECT_NEAR(1.0 / relative_density(oil, 0.5e9).value, 0.8613, 5e-5);
  EXPECT_NEAR(1.0 / relative_density(oil, 1e9).value, 0.8139, 5e-5);
  EXPECT_NEAR(log_relative_viscosity(oil, 0.0).value, 0.0, 1e-14);
  EXPECT_EQ(relative_density(oil, 0.0).value, 1.0);
  EXPECT_NEAR(1e9 * isoviscous_coefficient(oil), 19.5, 0.05);
}

TEST(FreeVolume, isoviscous_coefficient_of_barus_law_is_its_own) {
  const Lubricant barus{.viscosity = 0.1, .pressure_viscosity = 2e-8, .viscosity_law = ViscosityLaw::barus};
  EXPECT_NEAR(isoviscous_coefficient(barus) / 2e-8, 1.0, 1e-9);
}

// Measured: 15.0 mPa s at 313 K where it is 27.6 at 298 K; densities of 795 and 805 kg/m^3.
TEST(FreeVolume, squalane_thins_and_expands_with_temperature) {
  const ThermalOil thermal{.temperature = 298.0};
  EXPECT_NEAR(0.0276 * std::exp(log_relative_viscosity(squalane(), thermal, 0.0, 313.15).value), 0.0150, 4e-4);
  EXPECT_NEAR(density_factor(squalane(), thermal, 0.0, 313.15), 795.5 / 804.9, 1e-3);
  EXPECT_NEAR(0.0276 * std::exp(log_relative_viscosity(by_yasutomi(), thermal, 0.0, 313.15).value), 0.0150, 8e-4);
}

double slope(const std::function<double(double)>& f, double x, double step) {
  return (f(x + step) - f(x - step)) / (2.0 * step);
}

// To 8 GPa: beyond what leaves the oil a liquid.
TEST(FreeVolume, derivatives_are_those_of_the_values) {
  for (const Lubricant& oil : {squalane(), by_yasutomi()}) {
    const ThermalOil thermal{.temperature = oil.temperature};
    for (const double p : {1e6, 0.3e9, 1e9, 3e9, 8e9}) {
      const double by_pressure = log_relative_viscosity(oil, p).derivative;
      EXPECT_NEAR(slope([&](double x) { return log_relative_viscosity(oil, x).value; }, p, 1e4) / by_pressure, 1.0,
                  1e-5);
      EXPECT_GT(by_pressure, 0.0);
      EXPECT_NEAR(
          slope([&](double x) { return relative_density(oil, x).value; }, p, 1e4) / relative_density(oil, p).derivative,
          1.0, 1e-5);
      for (const double T : {280.0, 320.0, 420.0}) {
        const auto at = [&](double x) { return log_relative_viscosity(oil, thermal, p, x).value; };
        EXPECT_NEAR(slope(at, T, 1e-3) / log_relative_viscosity(oil, thermal, p, T).derivative, 1.0, 1e-5);
      }
    }
    EXPECT_NEAR(free_volume_thinning(oil), -log_relative_viscosity(oil, thermal, 0.0, oil.temperature).derivative,
                1e-15);
  }
}

}  // namespace
}  // namespace gearfilm

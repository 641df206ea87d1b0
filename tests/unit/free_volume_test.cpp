// Oils by their free volume: squalane against values worked out apart.
#include <gtest/gtest.h>

#include <cmath>

#include "lubricant/thermal_oil.hpp"
#include "table3.hpp"

namespace gearfilm {
namespace {

// The laws' own constants are those of squalane.
const Lubricant squalane{
    .viscosity = 0.0276, .viscosity_law = Doolittle{}, .density_law = Tait{}, .temperature = 298.0};
const Lubricant by_yasutomi{.viscosity = 0.0276, .viscosity_law = Yasutomi{}, .temperature = 298.0};

TEST(FreeVolume, squalane_at_one_temperature) {
  const Lubricant& oil = squalane;
  for (const auto& [pressure, viscosity] : {std::pair{0.2e9, 0.897}, {0.5e9, 39.2}, {1e9, 1.00e4}}) {
    EXPECT_NEAR(oil.viscosity * std::exp(log_relative_viscosity(oil, pressure).value) / viscosity, 1.0, 5e-3);
  }
  EXPECT_NEAR(1.0 / relative_density(oil, 0.5e9).value, 0.8613, 5e-5);
  EXPECT_NEAR(1.0 / relative_density(oil, 1e9).value, 0.8139, 5e-5);
  EXPECT_NEAR(log_relative_viscosity(oil, 0.0).value, 0.0, 1e-14);
  EXPECT_EQ(relative_density(oil, 0.0).value, 1.0);
  EXPECT_NEAR(1e9 * isoviscous_coefficient(oil), 19.5, 0.05);
}

// Measured: 15.0 mPa s at 313 K where it is 27.6 at 298 K; densities of 795 and 805 kg/m^3.
TEST(FreeVolume, squalane_thins_and_expands_with_temperature) {
  const ThermalOil thermal{.temperature = 298.0};
  EXPECT_NEAR(0.0276 * std::exp(log_relative_viscosity(squalane, thermal, 0.0, 313.15).value), 0.0150, 4e-4);
  EXPECT_NEAR(density_factor(squalane, thermal, 0.0, 313.15), 795.5 / 804.9, 1e-3);
  EXPECT_NEAR(0.0276 * std::exp(log_relative_viscosity(by_yasutomi, thermal, 0.0, 313.15).value), 0.0150, 8e-4);
}

TEST(FreeVolume, temperature_viscosity_is_that_of_the_law) {
  for (const Lubricant& oil : {squalane, by_yasutomi}) {
    EXPECT_EQ(temperature_viscosity(oil), -log_relative_viscosity(oil, {.temperature = 298.0}, 0.0, 298.0).derivative);
  }
}

TEST(FreeVolume, constants_that_leave_no_liquid_are_refused) {
  Lubricant oil = squalane;
  oil.viscosity_law = Doolittle{.R0 = 0.98};
  oil.temperature = 250.0;
  table3::expect_input_error_naming("no free volume", [&] { check(oil); });
  oil.viscosity_law = Yasutomi{.glass_temperature = 260.0};
  table3::expect_input_error_naming("a glass", [&] { check(oil); });
}

}  // namespace
}  // namespace gearfilm

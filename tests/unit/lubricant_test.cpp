// An oil by the laws of Roelands, Barus, Dowson and Higginson: values, and oils that are refused.
#include "lubricant/lubricant.hpp"

#include <cmath>
#include <limits>

#include "table3.hpp"

namespace gearfilm {

namespace {

using table3::expect_input_error_naming;

Lubricant table3_oil() { return {.viscosity = 0.04, .pressure_viscosity = 2.2e-8}; }

TEST(Lubricant, follows_the_published_laws) {
  const Lubricant oil = table3_oil();
  const double p = 1.0e9;
  EXPECT_DOUBLE_EQ(relative_density(oil, p).value, (5.9e8 + 1.34 * p) / (5.9e8 + p));
  const double z = 2.2e-8 * 1.96e8 / (std::log(0.04) + 9.67);
  const double exponent = (std::log(0.04) + 9.67) * (std::pow(1.0 + p / 1.96e8, z) - 1.0);
  EXPECT_NEAR(log_relative_viscosity(oil, p).value, exponent, 1e-14 * exponent);
  Lubricant barus = oil;
  barus.viscosity_law = Barus{};
  EXPECT_DOUBLE_EQ(log_relative_viscosity(barus, p).value, 22.0);
}

TEST(Lubricant, density_is_limited_by_134_percent) {
  EXPECT_NEAR(relative_density(table3_oil(), 1e16).value, 1.34, 1e-7);
}

TEST(Lubricant, incompressible_fluid_keeps_its_density) {
  Lubricant oil = table3_oil();
  oil.density_law = Incompressible{};
  EXPECT_EQ(relative_density(oil, 3e9).value, 1.0);
  EXPECT_EQ(relative_density(oil, 3e9).derivative, 0.0);
}

TEST(Lubricant, small_pressures_keep_their_digits) {
  const Lubricant oil = table3_oil();
  // To first order ln(eta/eta_0) = alpha_B p; the next term is p/p_0, 5e-9, smaller.
  EXPECT_NEAR(log_relative_viscosity(oil, 1.0).value / oil.pressure_viscosity, 1.0, 1e-8);
}

TEST(Lubricant, check_accepts_the_oil_of_table3) { EXPECT_NO_THROW(check(table3_oil())); }

TEST(Lubricant, check_refuses_values_that_are_not_positive) {
  for (const double wrong : {0.0, -0.04, std::numeric_limits<double>::quiet_NaN()}) {
    Lubricant oil = table3_oil();
    oil.viscosity = wrong;
    expect_input_error_naming("lubricant_viscosity", [&] { check(oil); });
    oil = table3_oil();
    oil.pressure_viscosity = wrong;
    expect_input_error_naming("lubricant_pressure_viscosity", [&] { check(oil); });
  }
}

TEST(Lubricant, isoviscous_coefficient_of_barus_law_is_its_own) {
  EXPECT_NEAR(isoviscous_coefficient({.viscosity = 0.1, .pressure_viscosity = 2e-8, .viscosity_law = Barus{}}) / 2e-8,
              1.0, 1e-9);
}

TEST(Lubricant, check_refuses_a_viscosity_outside_roelands_law_only_for_roelands) {
  Lubricant oil = table3_oil();
  oil.viscosity = 6e-5;  // e^-9.67 = 6.31e-5
  expect_input_error_naming("lubricant_viscosity = 6e-05", [&] { check(oil); });
  oil.viscosity_law = Barus{};
  EXPECT_NO_THROW(check(oil));
}

}  // namespace
}  // namespace gearfilm

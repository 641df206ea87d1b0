// What every law of viscosity and of density must be, whatever it says: each of the two lists of laws is tested here.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "lubricant/lubricant.hpp"

namespace gearfilm {
namespace {

template <class Laws>
struct TypesOf;
template <class... Law>
struct TypesOf<std::variant<Law...>> {
  using type = testing::Types<Law...>;
};

// The names of tests end in that of the law.
struct Named {
  template <class Law>
  static std::string GetName(int) {
    return std::string(Law::name);
  }
};

// Central differences are off by (step/x)^2 of the value and by round-off over step/x, both below 1e-9.
double slope(const std::function<double(double)>& f, double x) {
  const double step = 1e-5 * x;
  return (f(x + step) - f(x - step)) / (2.0 * step);
}

// From the inlet to beyond where an oil is a liquid [Pa].
constexpr auto pressures = {1e6, 1e8, 3e8, 5e8, 1e9, 3e9, 8e9};

template <class Law>
class EveryViscosityLaw : public testing::Test {
protected:
  const AmbientOil oil{
      .viscosity = 0.0276, .pressure_viscosity = 1.95e-8, .temperature = 298.0, .temperature_viscosity = 0.04};
  const typename Law::Evaluator eta{Law(), oil};

  double isothermal(double p) const { return eta.log_viscosity(p).value; }
  double by_temperature(double p) const { return eta.log_viscosity(isothermal(p), p, oil.temperature).derivative; }
};
TYPED_TEST_SUITE(EveryViscosityLaw, TypesOf<AnyViscosityLaw>::type, Named);

TYPED_TEST(EveryViscosityLaw, has_constants_that_may_be_given_and_make_an_oil) {
  TypeParam law;
  law.each_constant([](double value, const OilConstant& constant) {
    EXPECT_LE(value, constant.upper) << constant.name;
    EXPECT_TRUE(constant.lower_open ? value > constant.lower : value >= constant.lower) << constant.name;
  });
  EXPECT_NO_THROW(law.check(this->oil));
}

TYPED_TEST(EveryViscosityLaw, is_ambient_at_zero_pressure_and_constant_below) {
  EXPECT_NEAR(this->isothermal(0.0), 0.0, 1e-14);
  EXPECT_NEAR(this->isothermal(-1e8), 0.0, 1e-14);
  EXPECT_EQ(this->eta.log_viscosity(-1e8).derivative, 0.0);
  EXPECT_GT(this->eta.log_viscosity(0.0).derivative, 0.0);
  EXPECT_DOUBLE_EQ(this->eta.heating_ratio(0.0, 0.0).value, 1.0);
  EXPECT_DOUBLE_EQ(this->eta.heating_ratio(0.0, -1e8).value, 1.0);
}

TYPED_TEST(EveryViscosityLaw, grows_with_pressure_by_its_derivative) {
  for (const double p : pressures) {
    const double derivative = this->eta.log_viscosity(p).derivative;
    EXPECT_GT(derivative, 0.0);
    EXPECT_NEAR(slope([&](double x) { return this->isothermal(x); }, p) / derivative, 1.0, 1e-7) << p;
  }
}

TYPED_TEST(EveryViscosityLaw, falls_with_temperature_by_its_derivative) {
  for (const double p : pressures) {
    const double isothermal = this->isothermal(p);
    EXPECT_NEAR(this->eta.log_viscosity(isothermal, p, this->oil.temperature).value, isothermal,
                1e-14 * (1.0 + isothermal));
    for (const double T : {280.0, 298.0, 320.0, 420.0, 700.0}) {
      const double derivative = this->eta.log_viscosity(isothermal, p, T).derivative;
      EXPECT_LT(derivative, 0.0);
      const auto at = [&](double x) { return this->eta.log_viscosity(isothermal, p, x).value; };
      EXPECT_NEAR(slope(at, T) / derivative, 1.0, 1e-7) << p << " " << T;
    }
  }
}

TYPED_TEST(EveryViscosityLaw, has_the_heating_ratio_of_its_derivatives) {
  const auto ratio = [&](double p) { return this->by_temperature(p) / this->by_temperature(0.0); };
  for (const double p : pressures) {
    const double isothermal = this->isothermal(p);
    const HeatingRatio found = this->eta.heating_ratio(isothermal, p);
    EXPECT_GT(found.value, 0.0);
    EXPECT_NEAR(found.value / ratio(p), 1.0, 1e-14) << p;
    // dg/dp of a law whose g does not change is nothing but round-off.
    const double by_pressure = found.derivative * this->eta.log_viscosity(p).derivative;
    EXPECT_NEAR(slope(ratio, p), by_pressure, 1e-6 * std::abs(by_pressure) + 1e-10 * found.value / p) << p;
  }
}

template <class Law>
class EveryDensityLaw : public testing::Test {
protected:
  static constexpr double T_0 = 298.0;  // [K]
  const typename Law::Evaluator rho{Law(), T_0};
};
TYPED_TEST_SUITE(EveryDensityLaw, TypesOf<AnyDensityLaw>::type, Named);

TYPED_TEST(EveryDensityLaw, is_ambient_at_zero_pressure_and_constant_below) {
  EXPECT_EQ(this->rho.density(0.0).value, 1.0);
  EXPECT_EQ(this->rho.density(-1e8).value, 1.0);
  EXPECT_EQ(this->rho.density(-1e8).derivative, 0.0);
}

TYPED_TEST(EveryDensityLaw, grows_with_pressure_by_its_derivative) {
  for (const double p : pressures) {
    const PressureFunction density = this->rho.density(p);
    const double difference = slope([&](double x) { return this->rho.density(x).value; }, p);
    EXPECT_NEAR(difference, density.derivative, 1e-7 * density.derivative + 1e-10 * density.value / p) << p;
  }
}

TYPED_TEST(EveryDensityLaw, does_not_change_with_temperature_at_that_of_the_oil) {
  if constexpr (!TypeParam::takes_expansion) {
    for (const double p : pressures) {
      EXPECT_EQ(TypeParam().expanded(p, this->T_0, this->T_0), 1.0);
      EXPECT_LT(TypeParam().expanded(p, this->T_0, this->T_0 + 50.0), 1.0);
    }
  }
}

}  // namespace
}  // namespace gearfilm

// Mean shear stresses against values computed by hand, and put back into their laws.
#include "lubricant/shear_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace gearfilm {
namespace {

constexpr double thickness = 1e-6;                             // [m]
const double log_newtonian = std::log(3.0 * 2.0 / thickness);  // 3 Pa s, 2 m/s

ShearLaw unlimited(ShearLawKind kind) { return {.kind = kind, .limiting_ratio = 0.0}; }

/// tau_m under a pressure gradient [MPa].
double stress_under(const ShearLaw& law, double gradient) {
  return 1e-6 * mean_shear(law, log_newtonian, 0.5 * thickness * gradient, 0.0).stress;
}

TEST(ShearLaw, eyring_with_a_pressure_gradient) {
  const ShearLaw law = unlimited(ShearLawKind::eyring);
  EXPECT_NEAR(stress_under(law, 0.0), 5.545177, 1e-6);
  EXPECT_NEAR(stress_under(law, 5e12), 5.467710, 1e-6);
  EXPECT_NEAR(stress_under(law, -4e13), 2.441193, 1e-6);
}

TEST(ShearLaw, carreau_with_a_pressure_gradient) {
  ShearLaw law = unlimited(ShearLawKind::carreau);
  law.carreau_modulus = 7e6;
  law.carreau_exponent = 0.4;
  EXPECT_NEAR(stress_under(law, 0.0), 4.588874, 1e-6);
  EXPECT_NEAR(stress_under(law, 5e12), 4.392290, 1e-6);
}

// Int g(tau) dz of both laws in closed form, with t from b to a.
double mean_rate(const ShearLaw& law, double stress, double S) {
  if (law.kind == ShearLawKind::eyring) {
    const double t = stress / law.eyring_stress, s = S / law.eyring_stress;
    return law.eyring_stress * std::sinh(t) * (s == 0.0 ? 1.0 : std::sinh(s) / s);
  }
  constexpr int intervals = 20000;  // Simpson
  double sum = 0.0;
  for (int n = 0; n <= intervals; ++n) {
    const double weight = n == 0 || n == intervals ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
    sum += weight * fluidity(law, stress + S * (2.0 * n / intervals - 1.0));
  }
  return sum / (3.0 * intervals);
}

TEST(ShearLaw, the_mean_stress_shears_the_oil_as_fast_as_the_surfaces_slide) {
  for (const ShearLawKind kind : {ShearLawKind::eyring, ShearLawKind::carreau}) {
    const ShearLaw law = unlimited(kind);
    for (const double sigma : {-24.0, -3.0, -0.02, 0.0, 1e-4, 0.5, 24.0}) {
      for (const double rate : {1e-6, 1e-2, 1.0, 1e5, 1e20}) {
        const double newtonian = rate * law.eyring_stress, S = sigma * law.eyring_stress;
        const MeanShear found = mean_shear(law, std::log(newtonian), S, 0.0);
        // The rates of both halves of the film cancel, for the most part, where the gradient is strong.
        const double rounding = 1e-14 * std::abs(fluidity(law, found.stress + std::abs(S))) / newtonian;
        EXPECT_NEAR(mean_rate(law, found.stress, S) / newtonian, 1.0, 1e-10 + rounding) << sigma << " " << rate;
        constexpr double step = 1e-5;
        const double above = mean_shear(law, std::log(newtonian) + step, S, 0.0).stress;
        const double below = mean_shear(law, std::log(newtonian) - step, S, 0.0).stress;
        EXPECT_NEAR((above - below) / (2.0 * step) / found.by_rate, 1.0, 1e-6) << sigma << " " << rate;
      }
    }
  }
}

/// 3/2 Int f(zeta) d zeta over [-1, 1], by Simpson's rule.
template <class Function>
double thinning_integral(Function f) {
  constexpr int intervals = 20000;
  double sum = 0.0;
  for (int n = 0; n <= intervals; ++n) {
    const double weight = n == 0 || n == intervals ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
    sum += weight * f(2.0 * n / intervals - 1.0);
  }
  return 1.5 * sum * 2.0 / (3.0 * intervals);
}

// 12/h^3 Int (z - h/2) g/p_x dz and 12/h^3 Int (z - h/2)^2 g/tau dz.
TEST(ShearLaw, shear_thins_the_flow_that_pressure_drives) {
  for (const ShearLawKind kind : {ShearLawKind::eyring, ShearLawKind::carreau}) {
    const ShearLaw law = unlimited(kind);
    for (const double sigma : {-6.0, 0.01, 0.2, 1.0, 6.0}) {
      for (const double rate : {1e-6, 1e-2, 1.0, 1e5}) {
        const double newtonian = rate * law.eyring_stress, S = sigma * law.eyring_stress;
        const double stress = mean_shear(law, std::log(newtonian), S, 0.0).stress;
        const auto at = [&](double zeta) { return stress + S * zeta; };
        const ShearThinning found = shear_thinning(law, std::log(newtonian), S);
        const double along = thinning_integral([&](double zeta) { return zeta * fluidity(law, at(zeta)) / S; });
        const double across = thinning_integral([&](double zeta) {
          return at(zeta) == 0.0 ? zeta * zeta : zeta * zeta * fluidity(law, at(zeta)) / at(zeta);
        });
        EXPECT_NEAR(found.log_along, std::log(along), 1e-5) << sigma << " " << rate;
        EXPECT_NEAR(found.log_across, std::log(across), 1e-5) << sigma << " " << rate;
      }
    }
  }
}

TEST(ShearLaw, without_a_gradient_flow_thins_by_the_slope_along_and_by_the_secant_across) {
  const ShearLaw law = unlimited(ShearLawKind::eyring);
  const double rate = 1e3, stress = std::asinh(rate);
  const ShearThinning found = shear_thinning(law, std::log(rate * law.eyring_stress), 0.0);
  EXPECT_NEAR(found.log_along, std::log(std::cosh(stress)), 1e-12);
  EXPECT_NEAR(found.log_across, std::log(std::sinh(stress) / stress), 1e-12);
  EXPECT_EQ(shear_thinning(unlimited(ShearLawKind::newtonian), 20.0, 1e6).log_along, 0.0);
  const ShearThinning still = shear_thinning(law, -INFINITY, 0.0);
  EXPECT_NEAR(still.log_along, 0.0, 1e-14);
  EXPECT_NEAR(still.log_across, 0.0, 1e-14);
}

TEST(ShearLaw, a_newtonian_oil_and_one_that_hardly_thins) {
  const ShearLaw newtonian = unlimited(ShearLawKind::newtonian);
  EXPECT_NEAR(mean_shear(newtonian, log_newtonian, 1e6, 0.0).stress, 6e6, 6e-4);
  ShearLaw stiff = unlimited(ShearLawKind::eyring);
  stiff.eyring_stress = 1e12;
  EXPECT_NEAR(mean_shear(stiff, log_newtonian, 1e6, 0.0).stress / 6e6, 1.0, 1e-10);
}

TEST(ShearLaw, viscosities_beyond_any_number_give_a_stress) {
  const ShearLaw law = unlimited(ShearLawKind::eyring);
  EXPECT_NEAR(mean_shear(law, 1000.0, 0.0, 0.0).stress,
              law.eyring_stress * (1000.0 - std::log(law.eyring_stress) + std::numbers::ln2), 1.0);
  EXPECT_TRUE(std::isfinite(mean_shear(unlimited(ShearLawKind::carreau), 600.0, 0.0, 0.0).stress));
}

TEST(ShearLaw, the_stress_ends_at_its_limit) {
  const ShearLaw law;
  const MeanShear limited = mean_shear(law, 40.0, 0.0, 2e9);
  EXPECT_DOUBLE_EQ(limited.stress, 0.045 * 2e9);
  EXPECT_EQ(limited.by_rate, 0.0);
  EXPECT_DOUBLE_EQ(mean_shear(law, 40.0, 0.0, 1e6).stress, law.limiting_stress);  // in the inlet
}

TEST(ShearLaw, many_places_have_the_stresses_of_each) {
  std::vector<double> shear_rates, gradients, loads;
  for (const double rate : {no_shear_rate, 1e-6, 1.0, 1e3, 1e30}) {
    for (const double gradient : {-1e9, -1e3, 0.0, 4e6}) {
      for (const double carried : {0.0, 1e6, 2e9}) {
        shear_rates.push_back(std::log(rate) + std::log(8e6));
        gradients.push_back(gradient);
        loads.push_back(carried);
      }
    }
  }
  const std::size_t count = shear_rates.size();
  for (const ShearLawKind kind :
       {ShearLawKind::newtonian, ShearLawKind::eyring, ShearLawKind::carreau, ShearLawKind::coulomb}) {
    for (const double limiting_ratio : {0.0, 0.045}) {
      const ShearLaw law{.kind = kind, .coefficient = 0.05, .limiting_ratio = limiting_ratio};
      std::vector<double> stresses(count), by_rate(count);
      mean_shears(law, {count, shear_rates.data(), gradients.data(), loads.data()}, stresses.data(), by_rate.data());
      for (std::size_t n = 0; n < count; ++n) {
        const MeanShear one = mean_shear(law, shear_rates[n], gradients[n], loads[n]);
        EXPECT_NEAR(stresses[n], one.stress, 1e-13 * one.stress) << static_cast<int>(kind) << " " << n;
        EXPECT_NEAR(by_rate[n], one.by_rate, 1e-13 * one.by_rate) << static_cast<int>(kind) << " " << n;
      }
    }
  }
}

TEST(ShearLaw, coulomb_knows_pressure_only) {
  const ShearLaw law{.kind = ShearLawKind::coulomb, .coefficient = 0.05};
  EXPECT_DOUBLE_EQ(mean_shear(law, -5.0, 1e7, 1e9).stress, 0.05e9);
}

}  // namespace
}  // namespace gearfilm

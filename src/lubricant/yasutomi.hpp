// Viscosity by the glass transition, the improved form of Yasutomi's law as it is used since Bair's book on
// high-pressure rheology (book and papers not looked up):
//   ln eta = const - 2.303 C_1 y/(C_2 + y),  y = (T - T_g) F,  T_g = T_g0 + A_1 ln(1 + A_2 p),  F = (1 + b_1 p)^b_2
// The constants are a fit by least squares to squalane by Doolittle's law (doolittle.hpp).
#pragma once

#include "gearfilm/error.hpp"
#include "lubricant/vector_math.hpp"
#include "lubricant/viscosity_law.hpp"

namespace gearfilm {

struct Yasutomi {
  static constexpr std::string_view name = "yasutomi", meaning = "the improved form";
  static constexpr bool takes_coefficients = false;

  double glass_temperature = 194.679;  ///< T_g0 [K]
  double A1 = 652.16;                  ///< [K]
  double A2 = 0.05e-9;                 ///< [1/Pa]
  double b1 = 7.7404e-9;               ///< [1/Pa]
  double b2 = -0.5974;
  double C1 = 16.0159;
  double C2 = 18.6786;  ///< [K]

  template <class Each>
  void each_constant(Each&& each) {
    each(glass_temperature, OilConstant{"yasutomi_glass_temperature", "T_g0", "K", 50.0, 500.0, false,
                                        "yasutomi: glass transition at ambient pressure"});
    each(A1, OilConstant{"yasutomi_a1", "A_1", "K", 0.0, 5000.0, false, "yasutomi: T_g0 + A_1 ln(1 + A_2 p)"});
    each(A2, OilConstant{"yasutomi_a2", "A_2", "1/Pa", 0.0, 1e-6, false, "yasutomi: see A_1"});
    each(b1, OilConstant{"yasutomi_b1", "b_1", "1/Pa", 0.0, 1e-6, false, "yasutomi: F = (1 + b_1 p)^b_2"});
    each(b2, OilConstant{"yasutomi_b2", "b_2", "-", -5.0, 0.0, false, "yasutomi: see b_1"});
    each(C1, OilConstant{"yasutomi_c1", "C_1", "-", 0.0, 100.0, true, "yasutomi: factor"});
    each(C2, OilConstant{"yasutomi_c2", "C_2", "K", 0.0, 1000.0, true, "yasutomi: temperature"});
  }

  void check(const AmbientOil& oil) const {
    if (oil.temperature > glass_temperature) return;
    throw InputError("lubricant_yasutomi_glass_temperature = " + shown(glass_temperature) +
                     " K makes the oil a glass at thermal_temperature = " + shown(oil.temperature) +
                     " K: give both in K");
  }

  /// -2.303 C_1 y/(C_2 + y) at p and T. Deep in the glass it goes on along its tangent.
  StateFunction log_viscosity(double pressure, double temperature) const {
    const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0;
    const double F = exp(b2 * log1p(b1 * p));
    const double above = temperature - glass_temperature - A1 * log1p(A2 * p);
    const double y = above * F, least = -0.5 * C2, kept = y > least ? y : least, sum = C2 + kept;
    const double slope = -2.303 * C1 * C2 / (sum * sum);                                // by y
    const double curvature = y > least ? -2.0 * slope / sum : 0.0;                      // by y twice
    const double F_growth = b2 * b1 / (1.0 + b1 * p);                                   // d ln F/dp
    const double growth = above * b2 * b1 / (1.0 + b1 * p) - A1 * A2 / (1.0 + A2 * p);  // dy/dp over F
    return {-2.303 * C1 * kept / sum + slope * (y - kept), slope * on * F * growth, slope * F,
            on * F * (curvature * F * growth + slope * F_growth)};
  }

  using Evaluator = StateEvaluator<Yasutomi>;
};

}  // namespace gearfilm

// Viscosity by C. J. A. Roelands, thesis, Delft 1966 (not looked up); over pressure eq. (9) of
// doi 10.1016/j.triboint.2013.01.017:
//   x = c [(1 + p/p_0)^z - 1],  c = ln eta_0 + 9.67,  z = alpha_B p_0/c,  p_0 = 1.96e8 Pa
//   ln(eta/eta_0) = (x + c) [(T - 138)/(T_0 - 138)]^(-S_0) - c,  S_0 = beta (T_0 - 138)/c
#pragma once

#include "gearfilm/error.hpp"
#include "lubricant/vector_math.hpp"
#include "lubricant/viscosity_law.hpp"

namespace gearfilm {

struct Roelands {
  static constexpr std::string_view name = "roelands", meaning{};
  static constexpr bool takes_coefficients = true;
  static constexpr double reference_pressure = 1.96e8;  ///< p_0 [Pa]
  static constexpr double lowest_log = 9.67;            ///< -ln of the viscosity 6.315e-5 Pa s at which all oils meet

  /// c
  static double span(const AmbientOil& oil) { return std::log(oil.viscosity) + lowest_log; }

  template <class Each>
  static void each_constant(Each&&) {}

  static void check(const AmbientOil& oil) {
    if (span(oil) > 0.0) return;
    throw InputError("lubricant_viscosity = " + shown(oil.viscosity) + " Pa s is not above " +
                     shown(std::exp(-lowest_log)) +
                     " Pa s, the lower limit of Roelands' law: give it in Pa s, or use the Barus law");
  }

  class Evaluator {
  public:
    Evaluator(const Roelands&, const AmbientOil& oil)
        : alpha_(oil.pressure_viscosity),
          span_(Roelands::span(oil)),
          inverse_span_(1.0 / span_),
          exponent_(alpha_ * reference_pressure / span_),
          inverse_warmth_(1.0 / (oil.temperature - pole)),
          temperature_exponent_(oil.temperature_viscosity * (oil.temperature - pole) / span_) {}

    PressureFunction log_viscosity(double pressure) const {
      const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0;
      // expm1 and log1p keep the digits of the small pressures in the inlet, where the film is made.
      const double ratio = p * inverse_reference, growth = expm1(exponent_ * log1p(ratio));
      // dx/dp = c z/p_0 (1 + p/p_0)^(z-1), and c z/p_0 = alpha_B
      return {span_ * growth, on * alpha_ * (1.0 + growth) / (1.0 + ratio)};
    }

    TemperatureFunction log_viscosity(double isothermal, double, double temperature) const {
      // The law ends at 138 K; an iteration may try less.
      const double above = temperature - pole > 1.0 ? temperature - pole : 1.0;
      const double factor = exp(-temperature_exponent_ * log(above * inverse_warmth_));
      return {(isothermal + span_) * factor - span_, -(isothermal + span_) * temperature_exponent_ * factor / above};
    }

    HeatingRatio heating_ratio(double isothermal, double) const {
      return {1.0 + inverse_span_ * isothermal, inverse_span_};
    }

  private:
    static constexpr double inverse_reference = 1.0 / reference_pressure, pole = 138.0;  // [1/Pa], [K]

    double alpha_;
    double span_;  // c
    double inverse_span_;
    double exponent_;              // z
    double inverse_warmth_;        // 1/(T_0 - 138 K)
    double temperature_exponent_;  // S_0
  };
};

}  // namespace gearfilm

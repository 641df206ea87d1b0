// Viscosity by C. Barus, American Journal of Science 45 (1893), and by the same exponential over temperature:
//   ln(eta/eta_0) = alpha_B p - beta (T - T_0)
#pragma once

#include "lubricant/viscosity_law.hpp"

namespace gearfilm {

struct Barus {
  static constexpr std::string_view name = "barus", meaning{};
  static constexpr bool takes_coefficients = true;

  template <class Each>
  static void each_constant(Each&&) {}
  static void check(const AmbientOil&) {}

  class Evaluator {
  public:
    Evaluator(const Barus&, const AmbientOil& oil) : oil_(oil) {}

    PressureFunction log_viscosity(double pressure) const {
      const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0;
      return {oil_.pressure_viscosity * p, on * oil_.pressure_viscosity};
    }

    TemperatureFunction log_viscosity(double isothermal, double, double temperature) const {
      return {isothermal - oil_.temperature_viscosity * (temperature - oil_.temperature), -oil_.temperature_viscosity};
    }

    static HeatingRatio heating_ratio(double, double) { return {1.0, 0.0}; }

  private:
    AmbientOil oil_;
  };
};

}  // namespace gearfilm

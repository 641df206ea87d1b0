#include "lubricant/thermal_oil.hpp"

namespace gearfilm {

ViscosityEvaluator viscosity_evaluator(const Lubricant& oil, const ThermalOil& thermal) {
  return viscosity_evaluator(oil.viscosity_law, {.viscosity = oil.viscosity,
                                                 .pressure_viscosity = oil.pressure_viscosity,
                                                 .temperature = thermal.temperature,
                                                 .temperature_viscosity = thermal.temperature_viscosity});
}

TemperatureFunction log_relative_viscosity(const Lubricant& oil, const ThermalOil& thermal, double pressure,
                                           double temperature) {
  return std::visit(
      [&](const auto& eta) { return eta.log_viscosity(eta.log_viscosity(pressure).value, pressure, temperature); },
      viscosity_evaluator(oil, thermal));
}

double density_factor(const Lubricant& oil, const ThermalOil& thermal, double pressure, double temperature) {
  return std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (Law::takes_expansion) {
          return 1.0 - thermal.expansion * (temperature - thermal.temperature);
        } else {
          return law.expanded(pressure, thermal.temperature, temperature);
        }
      },
      oil.density_law);
}

double temperature_viscosity(const Lubricant& oil) {
  return -log_relative_viscosity(oil, {.temperature = oil.temperature}, 0.0, oil.temperature).derivative;
}

}  // namespace gearfilm

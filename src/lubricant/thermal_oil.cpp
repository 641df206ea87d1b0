#include "gearfilm/lubricant/thermal_oil.hpp"

namespace gearfilm {

ViscosityByTemperature::ViscosityByTemperature(const Lubricant& oil, const ThermalOil& thermal)
    : reference_(thermal.temperature),
      beta_(thermal.temperature_viscosity),
      inverse_span_(1.0 / (thermal.temperature - pole)) {
  if (oil.viscosity_law == ViscosityLaw::barus) return;
  c_ = roelands_span(oil);
  exponent_ = beta_ * (reference_ - pole) / c_;
}

TemperatureFunction log_relative_viscosity(const Lubricant& oil, const ThermalOil& thermal, double pressure,
                                           double temperature) {
  const ViscosityByTemperature law(oil, thermal);
  const double isothermal = log_relative_viscosity(oil, pressure).value;
  return oil.viscosity_law == ViscosityLaw::barus ? law.log_viscosity<ViscosityLaw::barus>(isothermal, temperature)
                                                  : law.log_viscosity<ViscosityLaw::roelands>(isothermal, temperature);
}

}  // namespace gearfilm

#include "gearfilm/lubricant/thermal_oil.hpp"

namespace gearfilm {

ViscosityByTemperature::ViscosityByTemperature(const Lubricant& oil, const ThermalOil& thermal)
    : laws_(oil),
      reference_(thermal.temperature),
      beta_(thermal.temperature_viscosity),
      inverse_span_(1.0 / (thermal.temperature - pole)) {
  if (oil.viscosity_law != ViscosityLaw::roelands) return;
  c_ = roelands_span(oil);
  exponent_ = beta_ * (reference_ - pole) / c_;
}

TemperatureFunction log_relative_viscosity(const Lubricant& oil, const ThermalOil& thermal, double pressure,
                                           double temperature) {
  const ViscosityByTemperature law(oil, thermal);
  const double isothermal = log_relative_viscosity(oil, pressure).value;
  TemperatureFunction found{};
  with_viscosity_law(oil,
                     [&]<ViscosityLaw kind>() { found = law.log_viscosity<kind>(isothermal, pressure, temperature); });
  return found;
}

double density_factor(const Lubricant& oil, const ThermalOil& thermal, double pressure, double temperature) {
  if (oil.density_law != DensityLaw::tait) return 1.0 - thermal.expansion * (temperature - thermal.temperature);
  const auto volume = [&](double T) { return oil.tait.volume(pressure, T - oil.reference_temperature).value; };
  return volume(thermal.temperature) / volume(temperature);
}

double free_volume_thinning(const Lubricant& oil) {
  const OilLaws laws(oil);
  return -(oil.viscosity_law == ViscosityLaw::yasutomi
               ? laws.log_viscosity_at<ViscosityLaw::yasutomi>(0.0, oil.temperature)
               : laws.log_viscosity_at<ViscosityLaw::doolittle>(0.0, oil.temperature))
              .by_temperature;
}

}  // namespace gearfilm

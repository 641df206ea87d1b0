// What a law of viscosity is: ln(eta/eta_0) over pressure and temperature, with its constants.
//
// A law is a struct of its constants, whose defaults make an oil. Its Evaluator has them at hand for one oil, without
// branches:
//   x(p) = ln(eta(p, T_0)/eta_0)                        log_viscosity(p), with dx/dp
//   ln(eta(p, T)/eta_0)                                 log_viscosity(x, p, T), with its derivative by T
//   g = (d ln eta/dT)(p, T_0)/(d ln eta/dT)(0, T_0)     heating_ratio(x, p), with dg/dx
// x is kept as a logarithm because eta itself spans 20 decades in a loaded contact. Below p = 0, met only inside an
// iteration, laws go on as constants with zero derivatives by p; dg/dx there is that at p = 0. Pressures in [Pa],
// temperatures in [K].
#pragma once

#include <concepts>

#include "lubricant/oil_law.hpp"

namespace gearfilm {

/// An oil at ambient pressure and T_0.
struct AmbientOil {
  double viscosity = 0.0;              ///< eta_0 [Pa s]
  double pressure_viscosity = 0.0;     ///< alpha_B [1/Pa]
  double temperature = 363.15;         ///< T_0 [K]
  double temperature_viscosity = 0.0;  ///< beta = -d ln eta/dT [1/K]; 0: as if it did not depend on temperature
};

/// g, by how much more the viscosity falls with temperature than at ambient pressure, and its derivative by
/// x = ln(eta/eta_0).
struct HeatingRatio {
  double value, derivative;
};

template <class Evaluator>
concept EvaluatesViscosity = requires(const Evaluator eta, double x, double p, double T) {
  { eta.log_viscosity(p) } -> std::same_as<PressureFunction>;
  { eta.log_viscosity(x, p, T) } -> std::same_as<TemperatureFunction>;
  { eta.heating_ratio(x, p) } -> std::same_as<HeatingRatio>;
};

template <class Law>
concept ViscosityLaw = requires(Law law, const AmbientOil& oil, void (*each)(double&, const OilConstant&)) {
  { Law::name } -> std::convertible_to<std::string_view>;     // in case files
  { Law::meaning } -> std::convertible_to<std::string_view>;  // a few words; empty where the name says all
  { Law::takes_coefficients } -> std::convertible_to<bool>;   // alpha_B and beta are given; else they follow from it
  law.each_constant(each);                                    // every constant with its description
  law.check(oil);                                             // throws InputError where both make no liquid
  requires EvaluatesViscosity<typename Law::Evaluator>;
  requires std::constructible_from<typename Law::Evaluator, const Law&, const AmbientOil&>;
};

/// The Evaluator of a law that knows ln eta, but for a constant, as a function of p and T: law.log_viscosity(p, T).
template <class Law>
class StateEvaluator {
public:
  StateEvaluator(const Law& law, const AmbientOil& oil)
      : law_(law), temperature_(oil.temperature), ambient_(law.log_viscosity(0.0, temperature_)) {}

  PressureFunction log_viscosity(double pressure) const {
    const StateFunction log_eta = law_.log_viscosity(pressure, temperature_);
    return {log_eta.value - ambient_.value, log_eta.by_pressure};
  }

  TemperatureFunction log_viscosity(double, double pressure, double temperature) const {
    const StateFunction log_eta = law_.log_viscosity(pressure, temperature);
    return {log_eta.value - ambient_.value, log_eta.by_temperature};
  }

  // Constants that no oil has might let it thicken with heat under pressure, or thin with pressure: in the one case g
  // stays above zero, in the other it keeps its value.
  HeatingRatio heating_ratio(double, double pressure) const {
    constexpr double least = 0.1;
    const StateFunction log_eta = law_.log_viscosity(pressure > 0.0 ? pressure : 0.0, temperature_);
    const double ratio = log_eta.by_temperature / ambient_.by_temperature;
    const double slope = log_eta.by_both / (log_eta.by_pressure * ambient_.by_temperature);
    return {ratio > least ? ratio : least, (ratio > least) & (log_eta.by_pressure > 0.0) ? slope : 0.0};
  }

private:
  Law law_;
  double temperature_;     // T_0
  StateFunction ambient_;  // at T_0
};

}  // namespace gearfilm

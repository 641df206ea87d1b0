// What heat meets in the oil: viscosity that falls with temperature, conductivity that grows with pressure.
//
//   ln eta(p,T)/eta_0 = (ln(eta(p,T_0)/eta_0) + c) f(T) - c,   f = ((T-138)/(T_0-138))^(-S_0),  c = ln eta_0 + 9.67,
//                       S_0 = beta (T_0-138)/c                                   with Roelands' law of pressure
//   ln eta(p,T)/eta_0 = ln(eta(p,T_0)/eta_0) - beta (T - T_0)                    with Barus' law
//   k(p) = k_0 (1 + c_1 p/(1 + c_2 p))
// and the laws of free_volume.hpp as they stand there. T_0 is the temperature at which the oil has its viscosity eta_0:
// there both are the isothermal laws of lubricant.hpp. Roelands 1966; k(p) with the constants of a paraffinic oil as
// Larsson and Andersson 2000 are quoted (neither was looked up). Temperatures in [K].
#pragma once

#include "gearfilm/lubricant/lubricant.hpp"

namespace gearfilm {

struct ThermalOil {
  double temperature = 363.15;               ///< T_0, at which viscosity and density are given [K]
  double temperature_viscosity = 0.0;        ///< beta = -d ln eta/dT at T_0 and ambient pressure [1/K]
  double conductivity = 0.137;               ///< k_0 [W/(m K)]
  double conductivity_pressure_1 = 1.72e-9;  ///< c_1 [1/Pa]
  double conductivity_pressure_2 = 5.4e-10;  ///< c_2 [1/Pa]
  double density = 870.0;                    ///< rho_0 [kg/m^3]
  double heat_capacity = 2000.0;             ///< c [J/(kg K)]
  double expansion = 0.0;                    ///< beta_rho = -d ln rho/dT [1/K]

  double conductivity_at(double pressure) const {
    return conductivity * (1.0 + conductivity_pressure_1 * pressure / (1.0 + conductivity_pressure_2 * pressure));
  }
};

/// A value and its derivative with respect to temperature [1/K].
struct TemperatureFunction {
  double value;
  double derivative;
};

/// rho(p,T)/rho(p,T_0): by Tait's law, else 1 - beta_rho (T - T_0).
double density_factor(const Lubricant& oil, const ThermalOil& thermal, double pressure, double temperature);
/// -d ln eta/dT at T_0 and ambient pressure, of a law by free volume [1/K].
double free_volume_thinning(const Lubricant& oil);

/// The viscosity of one oil as a function of temperature, without branches, for loops in vectors.
class ViscosityByTemperature {
public:
  ViscosityByTemperature(const Lubricant& oil, const ThermalOil& thermal);

  /// ln(eta(p,T)/eta_0) from that of the isothermal law at the same pressure.
  template <ViscosityLaw law>
  TemperatureFunction log_viscosity(double isothermal, double pressure, double temperature) const {
    if constexpr (law == ViscosityLaw::doolittle || law == ViscosityLaw::yasutomi) {
      const StateFunction log_eta = laws_.log_viscosity_at<law>(pressure, temperature);
      return {log_eta.value, log_eta.by_temperature};
    }
    if constexpr (law == ViscosityLaw::barus) return {isothermal - beta_ * (temperature - reference_), -beta_};
    // The law ends at 138 K; an iteration may try less.
    const double above = temperature - pole > 1.0 ? temperature - pole : 1.0;
    const double factor = exp(-exponent_ * log(above * inverse_span_));
    return {(isothermal + c_) * factor - c_, -(isothermal + c_) * exponent_ * factor / above};
  }

private:
  static constexpr double pole = 138.0;  // [K]

  OilLaws laws_;
  double reference_;  ///< T_0
  double beta_;
  double inverse_span_;  ///< 1/(T_0 - 138 K)
  double c_ = 0.0;
  double exponent_ = 0.0;  ///< S_0
};

/// ln(eta(p,T)/eta_0).
TemperatureFunction log_relative_viscosity(const Lubricant& oil, const ThermalOil& thermal, double pressure,
                                           double temperature);

}  // namespace gearfilm

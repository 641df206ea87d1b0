// What heat meets in the oil: viscosity and density that fall with temperature, conductivity that grows with pressure.
//
//   k(p) = k_0 (1 + c_1 p/(1 + c_2 p))
// with the constants of a paraffinic oil as Larsson and Andersson 2000 are quoted (not looked up). How viscosity and
// density depend on temperature is part of their laws (lubricant.hpp). T_0 is the temperature at which the oil has its
// viscosity eta_0; there they are those of the isothermal oil. Temperatures in [K].
#pragma once

#include "lubricant/lubricant.hpp"

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

/// rho(p,T)/rho(p,T_0): by the law of density where it knows, else 1 - beta_rho (T - T_0).
double density_factor(const Lubricant& oil, const ThermalOil& thermal, double pressure, double temperature);

/// -d ln eta/dT at T_0 and ambient pressure, of a law that does not take beta [1/K].
double temperature_viscosity(const Lubricant& oil);

/// The law of viscosity with beta and T_0 of the thermal oil, for loops.
ViscosityEvaluator viscosity_evaluator(const Lubricant& oil, const ThermalOil& thermal);

/// ln(eta(p,T)/eta_0).
TemperatureFunction log_relative_viscosity(const Lubricant& oil, const ThermalOil& thermal, double pressure,
                                           double temperature);

}  // namespace gearfilm

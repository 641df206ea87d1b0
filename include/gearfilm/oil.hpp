// The oil of a case: its laws of viscosity and density at the temperature of the case.
#pragma once

#include <utility>

#include "gearfilm/case.hpp"

namespace gearfilm {

class Oil {
public:
  explicit Oil(Case of) : case_(std::move(of)) {}

  /// Viscosity eta(p) [Pa s] at a pressure p [Pa].
  double viscosity(double pressure) const;
  /// Density over that at ambient pressure, rho(p)/rho(0) [-], at a pressure p [Pa].
  double density_ratio(double pressure) const;
  /// Pressure-viscosity coefficient [1/Pa]: alpha_B, or alpha* of a law that does not take it.
  double pressure_viscosity() const;
  /// Temperature of the oil that enters the contact [K].
  double temperature() const;

private:
  Case case_;
};

}  // namespace gearfilm

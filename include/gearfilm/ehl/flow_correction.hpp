// What heat across the film makes of the flow along it: fields that Reynolds' equation is given.
//
//   xi_R = F rho H^3/(eta lambda),  ln F = theta (1 + ln(eta/eta_0)/c),  eta = eta(p, T_0)
//   wedge d(rho H (U + W))/dX,  rho = r rho(p)
// They stay as they are while a film is solved for: theta, ln F at ambient pressure, rather than F, because where
// pressure changes F changes with it, by many decades. c = ln eta_0 + 9.67 with Roelands' law, by which the oil as warm
// as that has it so at all pressures (thermal_oil.hpp); infinite with Barus'.
#pragma once

#include <vector>

namespace gearfilm {

/// Compact fields of a contact's own nodes.
struct FlowCorrection {
  std::vector<double> thinning;  ///< theta
  std::vector<double> wedge;     ///< W, of u_m* [-]
  std::vector<double> density;   ///< r

  /// None: theta = 0, W = 0, r = 1.
  bool empty() const { return thinning.empty(); }
};

}  // namespace gearfilm

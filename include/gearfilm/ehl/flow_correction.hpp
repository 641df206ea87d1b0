// What heat across the film makes of the flow along it: fields that Reynolds' equation is given.
//
//   xi_R = F rho H^3/(eta lambda),  wedge d(rho H (U + W))/dX,  rho = r rho(p),  eta = eta(p, T_0)
// They stay as they are while a film is solved for.
#pragma once

#include <vector>

namespace gearfilm {

/// Compact fields of a contact's own nodes.
struct FlowCorrection {
  std::vector<double> log_flow_factor;  ///< ln F
  std::vector<double> wedge;            ///< W, of u_m* [-]
  std::vector<double> density;          ///< r

  /// None: F = 1, W = 0, r = 1.
  bool empty() const { return log_flow_factor.empty(); }
};

}  // namespace gearfilm

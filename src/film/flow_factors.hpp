// What heat across the film, and a shear law that is not Newton's, make of the flow: fields that Reynolds' equation is
// given.
//
//   xi_R = F S rho H^3/(eta lambda),  ln F = theta g(p),  eta = eta(p, T_0)
//   ln S = (m/2) ln[1 + exp 2 (kappa + ln(eta/eta_0) - ln F)];  across the entrainment A xi_R
//   wedge d(rho H (U + W))/dX,  rho = r rho(p)
// They stay as they are while a film is solved for: theta, ln F at ambient pressure, rather than F, because where
// pressure changes F changes with it, by many decades. g is d ln eta/dT at T_0 over that at ambient pressure
// (viscosity_law.hpp): in oil that is evenly warmer than T_0 by little, ln F is theta g at all pressures, by the laws
// of Roelands and Barus also where it is warmer by much. Likewise kappa rather than S: with m = 1 it is Eyring's law,
// S = sqrt(1 + (eta u_s/(h tau_0))^2) where pressure drives little, with m = 1 - n Carreau's far from Newton's; kappa
// is what gives the right S at the present state.
#pragma once

#include <cstddef>
#include <vector>

#include "lubricant/vector_math.hpp"

namespace gearfilm {

/// Compact fields of a contact's own nodes.
struct FlowFactors {
  std::vector<double> log_poiseuille;      ///< theta
  std::vector<double> entrainment_excess;  ///< W, of u_m* [-]
  std::vector<double> density_ratio;       ///< r
  std::vector<double> shear_index;         ///< kappa
  std::vector<double> cross_flow;          ///< A
  double shear_power = 1.0;                ///< m
  bool sheared = false;                    ///< on all processes: S and A may differ from 1

  /// None: theta = 0, W = 0, r = 1, S = 1, A = 1.
  bool empty() const { return log_poiseuille.empty(); }

  /// So many nodes that correct nothing.
  static FlowFactors none(std::size_t nodes);
};

/// ln S and its derivative by x = ln(eta/eta_0) - ln F.
struct LogShearFactor {
  double value, derivative;
};
inline LogShearFactor log_shear_factor(double power, double kappa, double x) {
  const double rate = exp(2.0 * (kappa + x));
  return {0.5 * power * log1p(rate), power * rate / (1.0 + rate)};
}
/// kappa of a given ln S >= 0 at x.
double shear_of(double power, double log_factor, double x);

}  // namespace gearfilm

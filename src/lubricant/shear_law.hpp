// Shear laws of the oil: how fast it shears under a stress, and the mean shear stress that drags one surface past the
// other.
//
//   gamma' = g(tau)/eta(p, T),  tau(z) = tau_m + (z - h/2) p_x,  u_s = Int_0^h gamma' dz
//   newtonian   g = tau                                    tau_m = eta u_s/h
//   eyring      g = tau_0 sinh(tau/tau_0)                  tau_m = tau_0 asinh[(eta u_s/(h tau_0)) S/sinh S]
//   carreau     g = tau (1 + (tau/G)^2)^((1/n-1)/2)        tau_m by Newton's method
//   coulomb     -                                          tau_m = mu_c p
// with S = h p_x/(2 tau_0), and |tau_m| <= max(tau_L0, Lambda p). Eyring: Johnson and Tevaarwerk 1977
// (doi 10.1098/rspa.1977.0129), with a pressure gradient Conry, Wang and Cusano 1987 (doi 10.1115/1.3261551);
// Carreau's law in terms of stress and the limit in proportion to pressure as Bair uses them. No source was looked up:
// the formulas follow from the laws, which stand above.
//
// eta spans more decades than a double has: its logarithm is what goes in.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gearfilm {

enum class ShearLawKind : std::uint8_t { newtonian, eyring, carreau, coulomb };

struct ShearLaw {
  ShearLawKind kind = ShearLawKind::eyring;
  double eyring_stress = 8e6;     ///< tau_0 [Pa]
  double carreau_modulus = 8e6;   ///< G [Pa]
  double carreau_exponent = 0.6;  ///< n [-]
  double coefficient = 0.0;       ///< mu_c of coulomb [-]
  double limiting_ratio = 0.045;  ///< Lambda [-]; 0: no limit
  double limiting_stress = 5e6;   ///< tau_L0 [Pa]

  /// tau_L at a pressure [Pa]; infinite without limit.
  double limit(double pressure) const;
};

/// A mean stress and how it follows the shear rate.
struct MeanShear {
  double stress = 0.0;   ///< tau_m >= 0 [Pa]
  double by_rate = 0.0;  ///< d tau_m/d ln(eta u_s/h) [Pa]; 0 at the limit
};

/// tau_m of a film of uniform viscosity, from ln(eta |u_s|/h), the shear stress that a Newtonian oil would have
/// [ln Pa]; h p_x/2 [Pa], of either sign; and the pressure [Pa], which limits it. The sign of tau_m is that of u_s.
MeanShear mean_shear(const ShearLaw& law, double log_newtonian, double half_gradient, double pressure);

/// Shear rate of a film that is not sheared [1/s]: its logarithm is finite.
inline constexpr double no_shear_rate = 1e-100;

/// Many places, with arrays of what mean_shear takes at each.
struct ShearedPlaces {
  std::size_t count = 0;
  const double* log_newtonian = nullptr;
  const double* half_gradient = nullptr;
  const double* pressure = nullptr;
};
/// mean_shear at each, by vector instructions for Eyring's law.
void mean_shears(const ShearLaw& law, const ShearedPlaces& at, double* stress, double* by_rate);

/// What the shear that drags makes of the flow that pressure drives, over that of a Newtonian oil of the same
/// viscosity.
struct ShearThinning {
  double log_along = 0.0;   ///< ln S of the flow along the sliding velocity
  double log_across = 0.0;  ///< the same at right angles to it
};

/// Shear thinning of a film of uniform viscosity by a law that knows a viscosity (not coulomb). Arguments are those of
/// mean_shear; the limit of the stress does not enter.
///   S = 12/h^3 Int (z - h/2) g(tau)/p_x dz,  tau = tau_m + (z - h/2) p_x;  across 12/h^3 Int (z - h/2)^2 g(tau)/tau dz
///   eyring: S = 3 (s cosh s - sinh s)/s^3 sqrt[1 + ((eta u_s/(h tau_0)) s/sinh s)^2],  s = h p_x/(2 tau_0)
ShearThinning shear_thinning(const ShearLaw& law, double log_newtonian, double half_gradient);
/// m: far from Newton's law S follows eta to this power (flow_factors.hpp).
double thinning_power(const ShearLaw& law);

/// g(tau) [Pa], of a stress of either sign; not of coulomb.
double fluidity(const ShearLaw& law, double stress);

}  // namespace gearfilm

#include "contact/waviness_formulas.hpp"

#include <cmath>
#include <numbers>

namespace gearfilm {

double remaining_amplitude(const ContactSolids& solids, const Lubricant& oil, const HertzContact& dry,
                           double entrainment_velocity, double wavelength) {
  const double modulus = solids.reduced_modulus, strain = dry.pressure / modulus;
  const double speed = 2.0 * oil.viscosity * entrainment_velocity / (modulus * solids.radius_x);
  const double M = 2.0 * std::numbers::pi * strain * strain / std::sqrt(speed);
  const double L = oil.pressure_viscosity * modulus * std::pow(speed, 0.25);
  const double nabla = wavelength / dry.a * std::pow(M, 0.75) / std::sqrt(L);
  return 1.0 / (1.0 + nabla * (0.125 + 0.04 * nabla));
}

}  // namespace gearfilm

#include "rating/micropitting.hpp"

#include <cmath>

namespace gearfilm {

double micropitting_film(const MicropittingContact& contact, const MicropittingOil& oil) {
  const double stiffness = oil.reduced_modulus * contact.reduced_radius;
  const double G = oil.pressure_viscosity * oil.reduced_modulus,
               U = oil.viscosity * contact.entrainment_velocity / stiffness, W = contact.line_load / stiffness;
  return 1.6 * contact.reduced_radius * std::pow(G, 0.6) * std::pow(U, 0.7) * std::pow(W, -0.13);
}

}  // namespace gearfilm

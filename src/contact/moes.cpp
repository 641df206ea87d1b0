// Moes' groups (doi 10.1016/0043-1648(92)90287-7). Both carry the speed through s = 2 eta_0 u_m/(E' R_x):
//   M = w/(E' R_x^2) s^(-3/4),  L = alpha_B E' s^(1/4),  D = R_x/R_y
// and of a load w' by unit length  M = w'/(E' R_x) s^(-1/2)
#include "contact/moes.hpp"

#include <cassert>
#include <cmath>

#include "contact/line_contact.hpp"

namespace gearfilm {

MoesGroups moes_groups(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  const double stiffness = solids.reduced_modulus * solids.radius_x;  // E' R_x [N/m]
  const double speed = 2.0 * oil.viscosity * operation.entrainment_velocity / stiffness;
  const double M = has_ellipse(solids) ? operation.load / (stiffness * solids.radius_x) * std::pow(speed, -0.75)
                                       : load_per_length(solids, operation) / stiffness / std::sqrt(speed);
  return {.M = M,
          .L = oil.pressure_viscosity * solids.reduced_modulus * std::pow(speed, 0.25),
          .D = solids.radius_x / solids.radius_y};
}

ContactOperation operation_for_moes(const ContactSolids& solids, const Lubricant& oil, double M, double L) {
  assert(M > 0.0 && L > 0.0);
  const double stiffness = solids.reduced_modulus * solids.radius_x;
  const double speed = std::pow(L / (oil.pressure_viscosity * solids.reduced_modulus), 4);
  return {.load = M * stiffness * solids.radius_x * std::pow(speed, 0.75),
          .entrainment_velocity = speed * stiffness / (2.0 * oil.viscosity)};
}

}  // namespace gearfilm

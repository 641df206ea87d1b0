// Moes' dimensionless groups of an elastohydrodynamic point contact, and of a line contact or a loaded face.
//
//   M = w/(E' R_x^2) (2 eta_0 u_m/(E' R_x))^(-3/4)      load
//   M = w'/(E' R_x) (2 eta_0 u_m/(E' R_x))^(-1/2)       load by unit length
//   L = alpha_B E' (2 eta_0 u_m/(E' R_x))^(1/4)         lubricant
//   D = R_x/R_y                                         radius ratio
// Source: Moes 1992 (Wear 159, doi 10.1016/0043-1648(92)90287-7); u_m is the mean (entrainment) velocity.
#pragma once

#include "contact/hertz.hpp"
#include "lubricant/lubricant.hpp"

namespace gearfilm {

/// Load and velocity of a contact.
struct ContactOperation {
  double load = 0.0;                  ///< w [N]
  double entrainment_velocity = 0.0;  ///< u_m [m/s]
};

struct MoesGroups {
  double M = 0.0;
  double L = 0.0;
  double D = 0.0;
};

MoesGroups moes_groups(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

/// The inverse: load [N] and entrainment velocity [m/s] of given solids and oil that have the groups M and L.
ContactOperation operation_for_moes(const ContactSolids& solids, const Lubricant& oil, double M, double L);

}  // namespace gearfilm

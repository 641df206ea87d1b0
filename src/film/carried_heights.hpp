// What heights of the flanks that travel take from the oil in a contact, and how they are carried through it.
//
//   q = rho_* t_w ,   t_w = w_1 z_1 + w_2 z_2 ,   rho_* = rho(p_h max(0, 1 - X^2 - (b/a)^-2 Y^2))       dimensionless
//   D q = dq/dT + d(U q)/dX = rho_* [(U - u_1/u_m*) w_1 z_1' + (U - u_2/u_m*) w_2 z_2'] + U t_w drho_*/dX
// w_i: the part of the heights that the contact does not flatten (contact/waviness_formulas.hpp). Differences damp a
// wave of N nodes by exp(-780 l/(N^3 Lambda)) over a length l. Therefore the scheme carries m + q, in which such waves
// are missing, and D q, which is known, is taken off. Surfaces that stand in the contact have no part of time in D q.
#pragma once

#include <vector>

#include "contact/scales.hpp"
#include "film/contact_conditions.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// Compact fields; empty where no heights travel.
struct CarriedHeights {
  std::vector<double> mass;       ///< q
  std::vector<double> transport;  ///< D q

  bool empty() const { return mass.empty(); }
};

CarriedHeights carried_heights(const Grid& grid, const Scales& scales, const ContactConditions& conditions);

}  // namespace gearfilm

// The two surfaces of a contact at one moment as its film sees them: values at the own nodes and rows of a grid.
//
//   E(X, Y) = offset + X^2/(2 Rbar) + D Y^2/2 + l(Y) + local(X) + beside(X, Y) - t(X, Y)     the gap without H_0 and
//   deformation, of (24) U(Y), S(Y) = (u_1 + u_2)/(2 u_m*), (u_1 - u_2)/u_m*      velocities of both surfaces along X
// Source: doi 10.1016/j.triboint.2013.01.017. Films, friction and heat read these and know nothing else of what the
// surfaces belong to. The difference of the velocities is given beside their mean, for in theirs it would be lost in
// round-off.
#pragma once

#include <vector>

#include "film/carried_heights.hpp"
#include "film/contact_conditions.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

class ContactFilm;

struct ContactSurfaces {
  ContactConditions conditions;     ///< of the dry contact that they are taken for in first guesses and limits
  std::vector<double> gap;          ///< E [-], compact: [nx][own rows]
  std::vector<double> entrainment;  ///< U of every own row [-]
  std::vector<double> sliding;      ///< S of every own row [-]
  CarriedHeights heights{};         ///< of flanks whose heights travel
  bool of_conditions = false;       ///< they are those of the conditions and have nothing besides
};

/// Surfaces that move alike in all rows, with one radius across.
ContactSurfaces surfaces_of(const Grid& grid, const Scales& scales, const ContactConditions& conditions);

/// Surfaces at the nodes of a coarser grid, taken from those at the same places of the finer one.
ContactSurfaces injected_surfaces(const Grid& fine_grid, const Grid& coarse_grid, const ContactSurfaces& fine);

/// Gives a film the surfaces of these conditions, unless it has them.
void move_surfaces(ContactFilm& film, const ContactConditions& conditions);

}  // namespace gearfilm

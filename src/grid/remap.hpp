// A field on a grid that reaches farther, or less far, with nodes at the same places.
#pragma once

#include <span>
#include <vector>

#include "grid/grid.hpp"

namespace gearfilm {

/// Whether two grids have the same steps, and nodes at the same places where both have any.
bool same_lattice(const GridShape& a, const GridShape& b);

/// The smallest shape that holds both, which have the same lattice.
GridShape enclosing(const GridShape& a, const GridShape& b);

/// The compact field of one grid on another of the same lattice, however each is cut; beyond its edges it goes on as it
/// is there (pressures end with 0). Collective.
std::vector<double> remapped(std::span<const double> field, const Grid& from, const Grid& to);

}  // namespace gearfilm

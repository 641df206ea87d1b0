// Int Int over the grid of values at its nodes, common to all processes.
#pragma once

#include <span>
#include <vector>

#include "gearfilm/ehl/grid.hpp"

namespace gearfilm {

/// h_x h_y times the sum of the values of this process, those of the others, and their mirror images: the own
/// nodes of one field, compact. Collective.
double integral(const Grid& grid, std::span<const double> values);
/// The same of each of some fields, one after the other.
std::vector<double> integrals(const Grid& grid, std::span<const double> values, std::size_t fields);

}  // namespace gearfilm

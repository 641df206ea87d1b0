// Int Int over the grid of values at its nodes, common to all processes.
#pragma once

#include <span>
#include <vector>

#include "grid/grid.hpp"

namespace gearfilm {

/// Int Int of one field over the whole domain, from its compact own nodes: the sum over all processes of the values,
/// each times h_x and the weight of its row (RowAxis::weight). Collective.
double integral(const Grid& grid, std::span<const double> values);
/// The integrals of some fields, one after the other.
std::vector<double> integrals(const Grid& grid, std::span<const double> values, std::size_t fields);

/// Int dX along each own row of a field, not common to all processes; its rows' parts of the integral are these times
/// Grid::row_weights.
std::vector<double> row_integrals(const Grid& grid, std::span<const double> values);

}  // namespace gearfilm

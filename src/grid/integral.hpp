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

/// The parts of an integral that the own rows have; not common to all processes.
std::vector<double> parts_of_rows(const Grid& grid, std::span<const double> values);

}  // namespace gearfilm

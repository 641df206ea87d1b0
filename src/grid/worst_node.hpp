// The node where a solver has failed: that of the largest residual, or of the first that is not a number.
#pragma once

#include <span>
#include <string>

#include "grid/grid.hpp"

namespace gearfilm {

struct WorstNode {
  double X = 0.0;
  double Y = 0.0;
  double value = 0.0;  ///< of the field there; NaN where it is not a number
};

/// The worst node of a compact field. Collective.
WorstNode worst_node(const Grid& grid, std::span<const double> field);

/// "residual 0.012 at X = 0.98, Y = 0.1".
std::string describe(const WorstNode& node);

}  // namespace gearfilm

#include "grid/worst_node.hpp"

#include <cmath>
#include <sstream>

namespace gearfilm {

WorstNode worst_node(const Grid& grid, std::span<const double> field) {
  struct {
    double size = -1.0;
    int rank = 0;
  } worst;
  worst.rank = grid.rank();
  WorstNode node;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      const double value = field[i * grid.y_count() + j];
      const double size = std::isfinite(value) ? std::abs(value) : HUGE_VAL;
      if (size <= worst.size) continue;
      worst.size = size;
      node = {grid.x(i), grid.y(j), value};
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, grid.comm());
  double values[3] = {node.X, node.Y, node.value};
  MPI_Bcast(values, 3, MPI_DOUBLE, worst.rank, grid.comm());
  return {values[0], values[1], values[2]};
}

std::string describe(const WorstNode& node) {
  std::ostringstream text;
  if (std::isfinite(node.value)) {
    text << "residual " << node.value;
  } else {
    text << "residual not a number";
  }
  text << " at X = " << node.X << ", Y = " << node.Y;
  return text.str();
}

}  // namespace gearfilm

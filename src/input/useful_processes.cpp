#include "input/useful_processes.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

constexpr int rows_of_a_process = 8;
constexpr int points_of_a_process = 4096;

}  // namespace

int useful_processes(const GridShape& grid, int heated_points, int present) {
  const long rows = grid.rows();
  const long by_rows = rows / rows_of_a_process;
  const long by_points = grid.nx * rows * (1 + heated_points) / points_of_a_process;
  return static_cast<int>(std::clamp(std::min(by_rows, by_points), 1L, static_cast<long>(present)));
}

}  // namespace gearfilm

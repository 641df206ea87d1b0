// How many processes a grid is worth.
#pragma once

#include "grid/grid.hpp"

namespace gearfilm {

/// As many of those present as shorten the work on a grid: each is to have 8 of the stored rows and 4096 points, which
/// are the nodes on them and, where films feel their heat, the points across each. Below that messages and the ends of
/// short loops take more time than is shared (docs/performance.md, "More processes").
int useful_processes(const GridShape& grid, int heated_points, int present);

}  // namespace gearfilm

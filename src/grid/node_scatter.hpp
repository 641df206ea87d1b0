// Values of a field at nodes of any process, for whom a process wants them: fields on other grids, all rows for output.
#pragma once

#include <petscsf.h>

#include <span>

#include "grid/grid.hpp"

namespace gearfilm {

class NodeScatter {
public:
  /// sources: where the vectors of the grid have the values that this process wants (Grid::vec_index). Collective.
  NodeScatter(const Grid& grid, std::span<const PetscInt> sources);

  /// The wanted values of a compact field. Collective.
  void operator()(std::span<const double> field, std::span<double> wanted) const;

private:
  PetscHandle<PetscSF, PetscSFDestroy> scatter_;
};

}  // namespace gearfilm

// The whole state of a lubricated pair at one time: what a march needs to go on from there.
#pragma once

#include <vector>

#include "dynamics/step_record.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// Motion and films of all present contacts, leading contact first.
struct PairState {
  Motion motion;
  std::vector<ContactFields> films;  ///< none in the dry model
  GridShape shape{};                 ///< of the grid that all films are on
};

/// The state of the pair on a grid of the same lattice that reaches farther, or less far (remap.hpp). Collective.
PairState remapped(const PairState& state, MPI_Comm comm, const GridShape& shape);

/// The same on the grid of which the state's has every second node, or every second line and all rows: fields in
/// between by cubic interpolation. Collective.
PairState refined(const PairState& state, MPI_Comm comm, Coarsening along = Coarsening::both);

}  // namespace gearfilm

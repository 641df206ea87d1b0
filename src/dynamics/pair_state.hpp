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

/// A state put on the grid that has a further node between every two of its own, along X and Y or, by x_only, along X
/// alone. Values there are interpolated by cubics; the motion stays. Collective.
PairState refined(const PairState& state, MPI_Comm comm, Coarsening along);

}  // namespace gearfilm

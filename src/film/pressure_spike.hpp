// The spike of pressure at the outlet (Petrusevich's): along a line in X pressure rises to its maximum in the contact,
// falls, and rises once more before it falls to nothing. It is thinner than the steps of most grids, so that its height
// depends on them where all else has long converged. Under little load the first maximum is lost in its flank: the only
// one that is left is sharp then, pressure falling from it by a tenth and more within a step.
#pragma once

#include "grid/field.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// Largest pressure behind the first valley of a line, or of its only, sharp maximum; over the own lines, zero where no
/// line has either. Not collective.
double spike_pressure(const Grid& grid, const Field<double>& pressure);

}  // namespace gearfilm

// The reference of a life: dry contacts under the static load shares, on the same way as a passage.
#pragma once

#include "dynamics/flank_recorder.hpp"

namespace gearfilm {

/// Sections below dry contacts at the places of a passage, Hertz's or along a whole face. rest: a pair just after a
/// contact has left. Collective. Throws SolveError where nothing carries the load.
Passage static_passage(const Grid& grid, const MeshModel& rest, const Passage& passage);

}  // namespace gearfilm

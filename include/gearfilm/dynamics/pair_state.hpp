// The whole state of a lubricated pair at one time: what a march needs to go on from there.
#pragma once

#include <vector>

#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

/// Motion and films of all present contacts, leading contact first.
struct PairState {
  Motion motion;
  std::vector<ContactFields> films;  ///< none in the dry model
};

}  // namespace gearfilm

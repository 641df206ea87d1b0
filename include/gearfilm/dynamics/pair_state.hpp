// The whole state of a lubricated pair at one time: what a march needs to go on from there.
#pragma once

#include <vector>

#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

/// The film of one contact: compact pressure, and the rate d(rho H)/dT at which it squeezes.
struct ToothFilm {
  std::vector<double> pressure;
  std::vector<double> rate;
};

/// Motion and films of all present contacts, leading contact first.
struct PairState {
  Motion motion;
  std::vector<ToothFilm> films;  ///< none in the dry model
};

}  // namespace gearfilm

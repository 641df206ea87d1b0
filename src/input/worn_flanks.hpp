// What wear has made of the flanks of a case so far.
#pragma once

#include <array>

#include "gear/flank.hpp"

namespace gearfilm {

struct WornFlanks {
  std::array<FlankCurve, 2> removed{};  ///< of pinion and wheel, the same over the face; or none
  double roughness_ratio = 1.0;         ///< present roughness of both over that of the case
};

}  // namespace gearfilm

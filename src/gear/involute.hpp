// The involute function.
#pragma once

#include <cmath>

namespace gearfilm {

/// inv(angle) [rad].
inline double involute(double angle) { return std::tan(angle) - angle; }

}  // namespace gearfilm

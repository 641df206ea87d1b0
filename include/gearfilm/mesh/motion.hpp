// The motion of a gear pair.
#pragma once

#include <algorithm>
#include <cmath>

namespace gearfilm {

/// The pair's degree of freedom: rigid displacement of the flanks and its velocity, dimensionless.
struct Motion {
  double H0 = 0.0;
  double V0 = 0.0;
};

inline Motion difference(const Motion& a, const Motion& b) { return {a.H0 - b.H0, a.V0 - b.V0}; }
/// The larger of both parts.
inline double length(const Motion& motion) { return std::max(std::abs(motion.H0), std::abs(motion.V0)); }

}  // namespace gearfilm

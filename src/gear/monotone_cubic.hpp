// A curve through points that has no extremes between them: cubics with the slopes of Fritsch and Carlson (SIAM J.
// Numer. Anal. 17, 238-246), harmonic means of the secants where these have one sign, else zero; constant beyond the
// ends.
#pragma once

#include <utility>
#include <vector>

namespace gearfilm {

/// Points of a flank's curve: radius of curvature and material removed [m], ascending in the former.
using FlankCurve = std::vector<std::pair<double, double>>;

class MonotoneCubic {
public:
  /// The curve through at least one point, ascending.
  explicit MonotoneCubic(FlankCurve points);

  double operator()(double at) const;

private:
  FlankCurve points_;
  std::vector<double> slopes_;  ///< at the points
};

}  // namespace gearfilm

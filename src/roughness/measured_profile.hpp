// A measured profile of a flank, split at a cutoff: longer waves are resolved by films, shorter ones are statistics.
//
// The mean line is the parabola of least squares: what is left of the flank's form, which the profile must not have.
// Gaussian filter of ISO 16610-21:  w(x) = exp(-pi (x/(alpha lambda_c))^2)/(alpha lambda_c),  alpha = (ln 2/pi)^(1/2),
// which halves waves of the length lambda_c; weights are normed to the points that there are near the ends. Resolved
// heights fade over a cutoff at both ends.
#pragma once

#include <utility>
#include <vector>

#include "roughness/topography.hpp"

namespace gearfilm {

struct SplitProfile {
  HeightProfile resolved;     ///< longer than the cutoff
  double resolved_rms = 0.0;  ///< [m]
  double shorter_rms = 0.0;   ///< root mean square of the heights that are filtered off [m]
  double form = 0.0;          ///< depth of the parabola over the length of the profile [m]
  double rms = 0.0;           ///< of all heights about the mean line [m]
};

/// Points s, z [m], ascending in s, at least three; cutoff lambda_c [m].
SplitProfile split_profile(const std::vector<std::pair<double, double>>& points, double cutoff);

}  // namespace gearfilm

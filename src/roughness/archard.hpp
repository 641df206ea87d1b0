// Wear of two rough flanks by Archard's law, with coefficients k_i [m^2/N] that belong to asperities.
//
//   d(depth_i)/dt = k_i p_a |u_s| ;  a point of flank i passes with u_i:
//   depth by one passage    k_i (|u_s|/u_i) Int p_a dx
//   volume by time          k_i Int Int p_a |u_s| dA
// Assumption: the contact hardly changes while the point passes. At the pitch point, where nothing slides, flanks do
// not wear; each has its own u_i, and the slower one wears more.
#pragma once

#include <cmath>

namespace gearfilm {

/// k_i of both flanks [m^2/N].
struct WearCoefficients {
  double pinion = 0.0;
  double wheel = 0.0;
};

/// line_load: Int p_a dx [N/m]; velocities [m/s]. [m].
inline double wear_depth(double coefficient, double sliding, double velocity, double line_load) {
  return coefficient * std::abs(sliding) / velocity * line_load;
}

/// force: of the asperities [N]. [m^3/s].
inline double wear_rate(double coefficient, double sliding, double force) {
  return coefficient * std::abs(sliding) * force;
}

}  // namespace gearfilm

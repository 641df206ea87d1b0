// The smallest ball that holds some points in the space of stress deviators.
//
// By the walk of Fischer, Gaertner and Kutz 2003 (Fast smallest-enclosing-ball computation in high dimensions, ESA
// 2003): the centre moves towards the hull of the points on the ball's surface until it meets another point, and points
// that no longer hold it are dropped. The walk is over a core of few points, which the farthest of all others joins
// until none lies outside.
#pragma once

#include <Eigen/Core>
#include <span>

namespace gearfilm {

/// Deviators of symmetric stresses as vectors (dang_van.hpp).
using DeviatorPoint = Eigen::Matrix<double, 5, 1>;

struct Ball {
  DeviatorPoint centre = DeviatorPoint::Zero();
  double radius = 0.0;
};

/// The smallest ball around at least one point; its radius is right to a relative 1e-9.
Ball smallest_ball(std::span<const DeviatorPoint> points);

}  // namespace gearfilm

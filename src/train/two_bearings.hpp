// A gear on a rigid shaft between two bearings A and B, in the plane of the force on it.
//
// y goes along the shaft from the middle of the gear, which lies by e beyond the middle of the span L: A is at
// -(L/2 + e), B at L/2 - e. Of a force P in the middle of the gear and a moment Q = int y dP about it
//   A takes s_A P - Q/L, B takes s_B P + Q/L ,     s_A = 1/2 - e/L ,  s_B = 1/2 + e/L
//   u = (s_A^2 K_A^-1 + s_B^2 K_B^-1) P            displacement of the gear's middle without Q
//   du/dy = [(s_B K_B^-1 - s_A K_A^-1) P + (K_A^-1 + K_B^-1) Q/L]/L
// Beyond a bearing, |e| > L/2, the gear is overhung. Both stiffnesses are one matrix but for a factor, K_B = K_A/r.
#pragma once

#include <Eigen/LU>

namespace gearfilm {

struct TwoBearings {
  double span = 0.0;                                    ///< L [m]
  double offset = 0.0;                                  ///< e, towards B at positive y [m]
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< K_A [N/m]
  double ratio = 1.0;                                   ///< r

  double share_of_first() const { return 0.5 - offset / span; }
  double share_of_second() const { return 0.5 + offset / span; }

  /// P by u: what the bearings are together to a gear that may tilt [N/m].
  Eigen::Matrix2d at_gear() const {
    const double first = share_of_first(), second = share_of_second();
    return stiffness / (first * first + second * second * ratio);
  }
  /// n.du/dy by a force along n [rad/N].
  double tilt_by_force(const Eigen::Vector2d& n) const {
    return n.dot(stiffness.inverse() * n) * (share_of_second() * ratio - share_of_first()) / span;
  }
  /// n.du/dy by a moment of such forces [rad/(N m)].
  double tilt_by_moment(const Eigen::Vector2d& n) const {
    return n.dot(stiffness.inverse() * n) * (1.0 + ratio) / (span * span);
  }
};

}  // namespace gearfilm

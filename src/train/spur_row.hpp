// The row of a front contact between two spur gears, h = B q.
//
//   h = -R_b1 phi_1 + R_b2 phi_2 - n.u_1 + n.u_2 ,      n = (sin alpha', cos alpha')
// in the frame whose x goes from the pinion's centre to the wheel's; the pinion turns counter-clockwise and drives, and
// both rotations count in their gear's own sense. n points along the line of action from the pinion's tangent point to
// the wheel's. A force F of the contact acts on the motion by B^T F.
#pragma once

#include <cmath>

#include "train/train.hpp"

namespace gearfilm {

/// One of the two gears that touch: which node it is, and its base radius [m].
struct SpurGearNode {
  std::size_t node = 0;
  double base_radius = 0.0;
};

/// alpha': the working pressure angle [rad].
inline Eigen::RowVectorXd spur_row(const Train& train, const SpurGearNode& pinion, const SpurGearNode& wheel,
                                   double pressure_angle) {
  const Eigen::RowVector2d n(std::sin(pressure_angle), std::cos(pressure_angle));
  return wheel.base_radius * train.rotation(wheel.node) - pinion.base_radius * train.rotation(pinion.node) +
         n * (train.translation(wheel.node) - train.translation(pinion.node));
}

/// The row of the approach of the reverse flanks, whose line of action is the mirror image: -h_b = b q,
///   -h_b = -R_b1 phi_1 + R_b2 phi_2 + n_b.u_1 - n_b.u_2 ,    n_b = (sin alpha', -cos alpha')
inline Eigen::RowVectorXd spur_back_row(const Train& train, const SpurGearNode& pinion, const SpurGearNode& wheel,
                                        double pressure_angle) {
  const Eigen::RowVector2d n(std::sin(pressure_angle), -std::cos(pressure_angle));
  return wheel.base_radius * train.rotation(wheel.node) - pinion.base_radius * train.rotation(pinion.node) -
         n * (train.translation(wheel.node) - train.translation(pinion.node));
}

/// The rows of what friction acts on: rotation of the pinion and its way along the flanks, t.u_1, then those of the
/// wheel, with t = (-cos alpha', sin alpha'), along which both flanks move.
inline Eigen::MatrixXd spur_friction_rows(const Train& train, const SpurGearNode& pinion, const SpurGearNode& wheel,
                                          double pressure_angle) {
  const Eigen::RowVector2d t(-std::cos(pressure_angle), std::sin(pressure_angle));
  Eigen::MatrixXd rows(4, train.freedoms());
  rows << train.rotation(pinion.node), t * train.translation(pinion.node), train.rotation(wheel.node),
      t * train.translation(wheel.node);
  return rows;
}

}  // namespace gearfilm

// The drive train around the mesh, as its motion feels it; dimensionless.
//
//   M y'' + C y' + K y = e_1 (sum_k F_k(y_1) - F*) - b^T F_b(b y) + G^T f + t sum_j A_j cos(2 pi c_j T/T_m + phi_j) ,
//   y_1 = H_0
// y are the relative coordinates of relative_motion.hpp as lengths over a^2/R_x*, less what the static force makes of
// them, and only those motions that forces between flanks can reach: across the line of action gears on isotropic
// bearings do not move. b y is by how much the reverse flanks have approached. K leaves y_1 alone: the torque alone
// determines the tooth force. f: what friction makes of the flanks' motion. t: of a torque whose amplitudes A_j are
// over its mean, with c_j cycles in a mesh period
//
// T_m. The rotation of the whole is not followed: the mean speed is constant.
#pragma once

#include <memory>
#include <vector>

#include "contact/scales.hpp"
#include "train/relative_motion.hpp"

namespace gearfilm {

/// A part of a torque that fluctuates.
struct TorqueHarmonic {
  double cycles = 0.0;     ///< c in a mesh period
  double amplitude = 0.0;  ///< A, over the mean
  double phase = 0.0;      ///< phi [rad]
};

/// Where a torque of such parts acts.
struct TorqueRipple {
  Eigen::RowVectorXd node;  ///< its rotation in q
  double mean = 0.0;        ///< [N m]
  std::vector<TorqueHarmonic> harmonics{};
};

/// Rows of q for what acts between flanks besides the force of a contact; empty where it does not act.
struct FlankRows {
  Eigen::RowVectorXd back{};   ///< the approach of the reverse flanks [m]
  Eigen::MatrixXd friction{};  ///< rotation of the pinion [rad], its way along the flanks [m]; those of the wheel
};

struct MeshTrain {
  Eigen::MatrixXd mass;             ///< M
  Eigen::VectorXd by_force;         ///< M^-1 e_1, by a force that parts the flanks
  Eigen::VectorXd by_back_force;    ///< -M^-1 b^T
  Eigen::MatrixXd by_displacement;  ///< -M^-1 K
  Eigen::MatrixXd by_velocity;      ///< -M^-1 C, without a damper beside the contacts
  Eigen::RowVectorXd back;          ///< b
  Eigen::MatrixXd friction{};       ///< G, 4 rows; empty where friction does not act on the motion
  Eigen::VectorXd by_ripple{};      ///< M^-1 t; empty without harmonics
  std::vector<TorqueHarmonic> harmonics{};

  /// K and C.
  Eigen::MatrixXd stiffness() const { return -mass * by_displacement; }
  Eigen::MatrixXd damping() const { return -mass * by_velocity; }
  Eigen::Index freedoms() const { return by_force.size(); }
  /// The sum of the harmonics after so many mesh periods.
  double ripple(double mesh_periods) const;
};

/// False where both sides are held, so that more than the torque determines the tooth force.
bool torque_determines_force(const Train& train);

/// damping: C of the train, whose tooth force the torque determines.
MeshTrain mesh_train(const Train& train, const Eigen::MatrixXd& damping, const FlankRows& rows,
                     const TorqueRipple& ripple, const Scales& scales);

}  // namespace gearfilm

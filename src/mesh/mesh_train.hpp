// The drive train around the mesh, as its motion feels it; dimensionless.
//
//   M y'' + C y' + K y = e_1 (sum_k F_k(y_1) - F*) - b^T F_b(b y) + G^T f + sum_i t_i a_i(T) ,  y_1 = H_0
//   a_i(T) = sum_j A_j cos(2 pi c_j T/T_m + phi_j)
// y are the relative coordinates of relative_motion.hpp as lengths over a^2/R_x*, less what the static force makes of
// them, and only those motions that forces between flanks can reach: across the line of action gears on isotropic
// bearings do not move. b y is by how much the reverse flanks have approached. K leaves y_1 alone: the torques alone
// determine the tooth force. f: what friction makes of the flanks' motion. t_i: of a torque whose amplitudes A_j are
// over its mean, with c_j cycles in a mesh period T_m. In a run-up the torque that drives stays, and the load is less
// by what all inertias take,
//   T_L(T) = T_L - phi_0^T M phi_0 Omega_1'/(phi_0 . t_L) ,  phi_0 the rotation of the whole with 1 of the pinion.
// The rotation of the whole is not followed: the mean speed is given.
#pragma once

#include <memory>
#include <vector>

#include "contact/scales.hpp"
#include "mesh/contact_path.hpp"
#include "mesh/motion.hpp"
#include "train/train_damping.hpp"

namespace gearfilm {

/// A part of a torque that fluctuates.
struct TorqueHarmonic {
  double cycles = 0.0;     ///< c in a mesh period
  double amplitude = 0.0;  ///< A, over the mean
  double phase = 0.0;      ///< phi [rad]
};

/// A torque on a node, in the sense in which its side turns.
struct NodeTorque {
  Eigen::RowVectorXd node;  ///< its rotation in q
  double mean = 0.0;        ///< [N m]
  std::vector<TorqueHarmonic> harmonics{};
  bool accelerates = false;  ///< of a run-up: what is left of it after the inertias have taken theirs
};

/// The motions y in the whole of the train, in SI.
struct WholeTrain {
  std::shared_ptr<const DampedTrain> damped;  ///< without a damper beside the contacts
  std::vector<NodeTorque> torques;
  Eigen::MatrixXd motions;  ///< q = motions y a^2/R_x*
};

/// Rows of q for what acts between flanks besides the force of a contact; empty where it does not act.
struct FlankRows {
  Eigen::RowVectorXd back{};   ///< the approach of the reverse flanks [m]
  Eigen::MatrixXd friction{};  ///< rotation of the pinion [rad], its way along the flanks [m]; those of the wheel
};

struct MeshTrain {
  /// What the fluctuation of one torque does.
  struct Ripple {
    Eigen::VectorXd by_torque;  ///< M^-1 t
    std::vector<TorqueHarmonic> harmonics;
  };

  Eigen::MatrixXd mass;             ///< M
  Eigen::VectorXd by_force;         ///< M^-1 e_1, by a force that parts the flanks
  Eigen::VectorXd by_back_force;    ///< -M^-1 b^T
  Eigen::MatrixXd by_displacement;  ///< -M^-1 K
  Eigen::MatrixXd by_velocity;      ///< -M^-1 C, without a damper beside the contacts
  Eigen::RowVectorXd back;          ///< b
  Eigen::MatrixXd friction{};       ///< G, 4 rows; empty where friction does not act on the motion
  std::vector<Ripple> ripples{};    ///< of the torques that fluctuate
  Eigen::VectorXd by_run_up{};      ///< of a run-up, by dr/dT of its speed; empty where it loads no tooth
  WholeTrain whole{};

  /// K and C.
  Eigen::MatrixXd stiffness() const { return -mass * by_displacement; }
  Eigen::MatrixXd damping() const { return -mass * by_velocity; }
  Eigen::Index freedoms() const { return by_force.size(); }
  /// What torques that fluctuate and a run-up add to y'' at T.
  Eigen::VectorXd torque_acceleration(const ContactPath& path, double T) const;
  /// y'' at T without friction; pull: what parts the flanks, less F*; back_force: on reverse flanks.
  Eigen::VectorXd acceleration(const Motion& motion, double pull, double back_force, const ContactPath& path,
                               double T) const;
};

/// False where both sides are held, so that more than the torque determines the tooth force.
bool torque_determines_force(const Train& train);

/// pinion_speed: the first [rad/s]. Of a train whose tooth force the torque determines.
MeshTrain mesh_train(const std::shared_ptr<const DampedTrain>& damped, const FlankRows& rows,
                     const std::vector<NodeTorque>& torques, const Scales& scales, double pinion_speed);

}  // namespace gearfilm

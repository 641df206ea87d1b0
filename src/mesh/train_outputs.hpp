// What a drive train does at a moment: its nodes, shafts and bearings, in SI. Of a state (y, v), the forces on the
// flanks and the time alone, whether dry contacts or films give the forces.
//
//   q = q_0 + Z y + phi_0 r(T) ,     K q_0 = b + B^T w* under the mean torques b and the static force w*, B q_0 = 0
//   M_0 r'' = sum_i (phi_0 . t_i) a_i(T) ,     M_0 = phi_0^T M phi_0: torques that fluctuate swing the whole
// q is less the mean rotation; r is that of the speed at the moment. An output is linear in q and q':
//   rotation and place of a node, their velocities;   shafts, grounds   k G q + c G q' ,  G q the twist phi_a - phi_b
//   bearings   K_b u + C_b u' ,  the force of the node on them, x along the line of centres to the wheel, y across it
// Dampers of elements count, those of modes (train.damping_ratio) belong to none. The energy of the motion follows
//   d/dT (v^T M v/2 + y^T K y/2) = power of torques + power of teeth - power of dampers
// where that of teeth is of F on h', and of friction, and that of torques of w* against it and of what fluctuates.
#pragma once

#include <string>

#include "mesh/mesh_model.hpp"

namespace gearfilm {

/// A moment of the motion; forces [-].
struct TrainMoment {
  double T = 0.0;
  Motion motion;
  double teeth = 0.0;          ///< sum of F_k
  double damper = 0.0;         ///< of a damper beside dry contacts, with V_0
  double back = 0.0;           ///< of reverse flanks
  Eigen::VectorXd friction{};  ///< -G^T f for each degree of freedom; empty where it does not act on the motion
};

struct TrainOutput {
  std::string name;
  std::string unit;
};

/// [W].
struct TrainPowers {
  double torques = 0.0, teeth = 0.0, dampers = 0.0;
};

class TrainOutputs {
public:
  /// The outputs of a mesh with a train, which must outlive them.
  explicit TrainOutputs(const MeshModel& mesh);

  /// Nodes first, then elements.
  const std::vector<TrainOutput>& list() const { return list_; }
  std::size_t first_of_elements() const { return first_of_elements_; }

  Eigen::VectorXd values(const TrainMoment& moment) const;
  /// Their derivatives by time [1/s].
  Eigen::VectorXd rates(const TrainMoment& moment) const;
  /// q'' [rad/s^2, m/s^2].
  Eigen::VectorXd acceleration(const TrainMoment& moment) const;

  TrainPowers powers(const TrainMoment& moment) const;
  double kinetic_energy(const Motion& motion) const;  ///< [J]
  double stored_energy(const Motion& motion) const;   ///< in shafts and bearings, less that at rest [J]

private:
  /// r, r' and r''.
  struct Swing {
    double way = 0.0, velocity = 0.0, acceleration = 0.0;
  };

  void add(const std::string& name, const std::string& unit, const Eigen::RowVectorXd& by_displacement,
           const Eigen::RowVectorXd& by_velocity);
  void add_nodes(const Train& train);
  void add_elements(const Train& train);
  Swing swing(double T) const;
  Eigen::VectorXd displacement(const TrainMoment& moment) const;
  Eigen::VectorXd velocity(const TrainMoment& moment) const;

  const MeshModel& mesh_;
  const MeshTrain& train_;
  Eigen::VectorXd at_rest_, rigid_;
  double rigid_inertia_ = 0.0;                      ///< M_0
  Eigen::MatrixXd mass_, stiffness_, dissipation_;  ///< of y in m
  Eigen::MatrixXd skew_;                            ///< part of K that stores nothing
  std::vector<TrainOutput> list_;
  std::size_t first_of_elements_ = 0;
  Eigen::MatrixXd by_displacement_, by_velocity_;  ///< one row an output
};

}  // namespace gearfilm

// The acceleration of a drive train around dry contacts, with its derivatives: that of mesh_train.hpp less
// M^-1 e_1 I_n c y_1', c of a damper beside the contacts (dry_flow.hpp).
#pragma once

#include "mesh/dry_force.hpp"

namespace gearfilm {

struct TrainAcceleration {
  Eigen::VectorXd value;
  Eigen::MatrixXd by_displacement, by_velocity;  ///< empty unless asked for
};

/// Dry contacts, and their forces in the motion.
struct LoadedContacts {
  const DryContacts& contacts;
  const std::vector<double>& forces;
};

/// Acceleration of a mesh with a train, whose contacts are these at T.
TrainAcceleration train_acceleration(const MeshModel& mesh, const LoadedContacts& loaded, double T,
                                     const Motion& motion, double damping, bool derivatives);

}  // namespace gearfilm

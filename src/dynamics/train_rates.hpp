// The acceleration of a drive train around dry contacts, with its derivatives (mesh_train.hpp).
//
//   y'' = M^-1 (e_1 (sum_k F_k(y_1) - F* - I_n c y_1') - b^T F_b(b y) - C y' - K y)
// c: of a damper beside the contacts (dry_flow.hpp).
#pragma once

#include "mesh/dry_force.hpp"

namespace gearfilm {

struct TrainAcceleration {
  Eigen::VectorXd value;
  Eigen::MatrixXd by_displacement, by_velocity;  ///< empty unless asked for
};

/// Of a mesh with a train, whose contacts are these at T.
TrainAcceleration train_acceleration(const MeshModel& mesh, const DryContacts& contacts, double T, const Motion& motion,
                                     double damping, bool derivatives);

}  // namespace gearfilm

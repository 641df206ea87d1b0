// The equations of a drive train (mesh_train.hpp) whose contacts are films, as those of bodies on which films press
// (body_equations.hpp), and its free oscillations.
//
//   s = (y, v) :   dy/dT - v = 0 ,
//   (M dv/dT + K y + C v - e_1 (sum_k F_k/f - F*) + A - sum_i t_i a_i)/F* = 0 ,    H_k = y_1
// f and A as in the equation of motion of a pair alone. F_b, at the approach b y, enters the rows of v by b^T/F*.
#pragma once

#include "dynamics/frequency_fit.hpp"
#include "mesh/mesh_train.hpp"

namespace gearfilm {

struct TrainLoad {
  double static_force = 1.0;  ///< F*
  double share = 1.0;         ///< f of F* that the films carry in the place of all contacts
  Eigen::VectorXd pressing;   ///< A, for each degree of freedom
  Eigen::VectorXd torques;    ///< M^-1 sum_i t_i a_i
};

BodyEquations equation_of_motion(const MeshTrain& train, const TrainLoad& load, std::size_t films);

/// The force of reverse flanks on it.
ReverseFlankForce reverse_flanks_in(const MeshTrain& train, double static_force,
                                    std::function<ReverseFlankForce::Value(double approach)> law);

/// Swings of the train on contacts of this stiffness [-], by the symmetric part of K.
Swings swings_of(const MeshTrain& train, double contact_stiffness);

/// Whether the contacts hold the flanks by as much as masses and shafts do, where states change by `shift` a time: of
/// light nodes beside the mesh.
bool contacts_hold(const Swings& swings, double shift);

}  // namespace gearfilm

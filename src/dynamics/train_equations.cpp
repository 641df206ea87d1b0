#include "dynamics/train_equations.hpp"

#include <utility>

#include "algebra/dense.hpp"

namespace gearfilm {

using Eigen::MatrixXd;
using Eigen::VectorXd;

BodyEquations equation_of_motion(const MeshTrain& train, const TrainLoad& load, std::size_t films) {
  const Eigen::Index n = train.freedoms();
  const MatrixXd none = MatrixXd::Zero(n, n), one = MatrixXd::Identity(n, n);
  VectorXd pressing = load.pressing;
  pressing[0] += load.static_force;
  pressing -= train.mass * load.torques;
  BodyEquations bodies{.mass = MatrixXd(2 * n, 2 * n),
                       .stiffness = MatrixXd(2 * n, 2 * n),
                       .constant = VectorXd(2 * n),
                       .force = MatrixXd::Zero(2 * n, static_cast<Eigen::Index>(films)),
                       .displacement = MatrixXd::Zero(static_cast<Eigen::Index>(films), 2 * n)};
  bodies.mass << one, none, none, train.mass / load.static_force;
  bodies.stiffness << none, -one, train.stiffness() / load.static_force, train.damping() / load.static_force;
  bodies.constant << VectorXd::Zero(n), pressing / load.static_force;
  bodies.force.row(n).setConstant(1.0 / (load.share * load.static_force));
  bodies.displacement.col(0).setOnes();
  return bodies;
}

ReverseFlankForce reverse_flanks_in(const MeshTrain& train, double static_force,
                                    std::function<ReverseFlankForce::Value(double approach)> law) {
  const Eigen::Index n = train.freedoms();
  Eigen::RowVectorXd approach(2 * n);
  VectorXd column(2 * n);
  approach << train.back, Eigen::RowVectorXd::Zero(n);
  column << VectorXd::Zero(n), train.back.transpose() / static_force;
  return {std::move(law), std::move(approach), std::move(column)};
}

Swings swings_of(const MeshTrain& train, double contact_stiffness) {
  MatrixXd K = train.stiffness();
  K = 0.5 * (K + K.transpose()).eval();
  K(0, 0) += contact_stiffness;
  const auto [values, shapes] = symmetric_eigen_pairs(K, 0.5 * (train.mass + train.mass.transpose()));
  return {values.cwiseMax(0.0).cwiseSqrt(), shapes, shapes.transpose() * train.mass, contact_stiffness};
}

// S e_1^T (shift^2 M + K + S e_1 e_1^T)^-1 e_1 is the contacts' part of what holds the flanks.
bool contacts_hold(const Swings& swings, double shift) {
  constexpr double much = 0.25;
  const VectorXd flanks = swings.shapes.row(0).cwiseAbs2();
  const VectorXd held = swings.rates.cwiseAbs2().array() + shift * shift;
  return swings.contact_stiffness * flanks.cwiseQuotient(held).sum() > much;
}

}  // namespace gearfilm

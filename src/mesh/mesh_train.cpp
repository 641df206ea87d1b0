#include "mesh/mesh_train.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

namespace gearfilm {

namespace {

/// An orthonormal basis of what a few vectors reach by powers of some matrices, e_1 first.
Eigen::MatrixXd reached(const std::vector<Eigen::VectorXd>& from, const std::vector<Eigen::MatrixXd>& matrices) {
  constexpr double round_off = 1e-11;
  const Eigen::Index size = from.front().size();
  Eigen::MatrixXd basis = Eigen::VectorXd::Unit(size, 0);
  const auto add = [&basis](const Eigen::VectorXd& vector, double scale) {
    Eigen::VectorXd rest = vector;
    for (int twice = 0; twice < 2; ++twice) rest -= basis * (basis.transpose() * rest);
    if (rest.norm() <= round_off * scale) return;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = rest.normalized();
  };
  for (const Eigen::VectorXd& vector : from) add(vector, vector.norm());
  // By the powers of the first matrix alone at first: what they reach does not depend on the others.
  for (Eigen::Index n = 0; n < basis.cols(); ++n) add(matrices.front() * basis.col(n), matrices.front().norm());
  for (Eigen::Index n = 0; n < basis.cols(); ++n) {
    for (const Eigen::MatrixXd& matrix : matrices) add(matrix * basis.col(n), matrix.norm());
  }
  return basis;
}

/// The sum of such parts after so many mesh periods.
double fluctuation(const std::vector<TorqueHarmonic>& harmonics, double mesh_periods) {
  double sum = 0.0;
  for (const TorqueHarmonic& one : harmonics) {
    sum += one.amplitude * std::cos(2.0 * std::numbers::pi * one.cycles * mesh_periods + one.phase);
  }
  return sum;
}

/// What a load in a run-up is less by an angular acceleration of the pinion, the first node [N m s^2]; of a train that
/// turns freely.
double torque_of_run_up(const DampedTrain& damped, const NodeTorque& load) {
  const Eigen::VectorXd rigid = damped.relative.rigid / (damped.train.rotation(0) * damped.relative.rigid).value();
  return rigid.dot(damped.train.mass() * rigid) / load.node.dot(rigid);
}

}  // namespace

bool torque_determines_force(const Train& train) {
  constexpr double round_off = 1e-9;
  const Eigen::MatrixXd K = relative_motion(train).projected(train.stiffness());
  return K.row(0).cwiseAbs().maxCoeff() <= round_off * K.cwiseAbs().maxCoeff();
}

Eigen::VectorXd MeshTrain::torque_acceleration(const ContactPath& path, double T) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(freedoms());
  if (!ripples.empty()) {
    const double passed = path.mesh_periods(T);
    for (const Ripple& ripple : ripples) sum += fluctuation(ripple.harmonics, passed) * ripple.by_torque;
  }
  if (by_run_up.size() > 0) sum += path.course().acceleration(T) * by_run_up;
  return sum;
}

Eigen::VectorXd MeshTrain::acceleration(const Motion& motion, double pull, double back_force, const ContactPath& path,
                                        double T) const {
  return by_force * pull + by_back_force * back_force + by_displacement * motion.q + by_velocity * motion.v +
         torque_acceleration(path, T);
}

MeshTrain mesh_train(const std::shared_ptr<const DampedTrain>& damped, const FlankRows& rows,
                     const std::vector<NodeTorque>& torques, const Scales& scales, double pinion_speed) {
  const Train& train = damped->train;
  const RelativeMotion& relative = damped->relative;
  const Eigen::MatrixXd K = relative.projected(train.stiffness());
  // Both sides of the equation over p_h R_x*, so that a mass is as in Scales::inertia.
  const double force = scales.pressure * scales.solids.radius_x;
  const Eigen::MatrixXd mass = relative.projected(train.mass()) / (force * scales.time * scales.time);
  const Eigen::MatrixXd inverse = mass.inverse();
  const Eigen::MatrixXd by_displacement = -inverse * K / force;
  const Eigen::MatrixXd by_velocity = -inverse * relative.projected(damped->damping) / (force * scales.time);
  std::vector<Eigen::VectorXd> forces = {inverse.col(0)};
  Eigen::RowVectorXd b = Eigen::RowVectorXd::Zero(K.cols());
  if (rows.back.size() > 0) {
    b = rows.back * relative.motions;
    forces.emplace_back(inverse * b.transpose());
  }
  Eigen::MatrixXd friction(0, K.cols());
  if (rows.friction.size() > 0) friction = rows.friction * relative.motions;
  for (const auto& row : friction.rowwise()) forces.emplace_back(inverse * row.transpose());
  std::vector<MeshTrain::Ripple> ripples;
  for (const NodeTorque& torque : torques) {
    if (torque.harmonics.empty()) continue;
    forces.emplace_back(torque.mean / scales.force(1.0) * inverse * (torque.node * relative.motions).transpose());
    ripples.push_back({forces.back(), torque.harmonics});
  }
  Eigen::VectorXd by_run_up;
  for (const NodeTorque& torque : torques) {
    if (!torque.accelerates) continue;
    const double moment = torque_of_run_up(*damped, torque) * pinion_speed / scales.time;
    forces.emplace_back(moment / scales.force(1.0) * inverse * (torque.node * relative.motions).transpose());
    by_run_up = forces.back();
  }
  const Eigen::MatrixXd V = reached(forces, {by_displacement, by_velocity});
  for (MeshTrain::Ripple& ripple : ripples) ripple.by_torque = V.transpose() * ripple.by_torque;
  return {.mass = V.transpose() * mass * V,
          .by_force = V.transpose() * inverse.col(0),
          .by_back_force = -V.transpose() * inverse * b.transpose(),
          .by_displacement = V.transpose() * by_displacement * V,
          .by_velocity = V.transpose() * by_velocity * V,
          .back = b * V,
          .friction = friction * V,
          .ripples = std::move(ripples),
          .by_run_up = by_run_up.size() > 0 ? Eigen::VectorXd(V.transpose() * by_run_up) : by_run_up,
          .whole = {.damped = damped, .torques = torques, .motions = relative.motions * V}};
}

}  // namespace gearfilm

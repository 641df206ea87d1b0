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

}  // namespace

double MeshTrain::ripple(double mesh_periods) const {
  double sum = 0.0;
  for (const TorqueHarmonic& one : harmonics) {
    sum += one.amplitude * std::cos(2.0 * std::numbers::pi * one.cycles * mesh_periods + one.phase);
  }
  return sum;
}

bool torque_determines_force(const Train& train) {
  constexpr double round_off = 1e-9;
  const Eigen::MatrixXd K = relative_motion(train).projected(train.stiffness());
  return K.row(0).cwiseAbs().maxCoeff() <= round_off * K.cwiseAbs().maxCoeff();
}

MeshTrain mesh_train(const Train& train, const Eigen::MatrixXd& damping, const FlankRows& rows,
                     const TorqueRipple& ripple, const Scales& scales) {
  const RelativeMotion relative = relative_motion(train);
  const Eigen::MatrixXd K = relative.projected(train.stiffness());
  // Both sides of the equation over p_h R_x*, so that a mass is as in Scales::inertia.
  const double force = scales.pressure * scales.solids.radius_x;
  const Eigen::MatrixXd mass = relative.projected(train.mass()) / (force * scales.time * scales.time);
  const Eigen::MatrixXd inverse = mass.inverse();
  const Eigen::MatrixXd by_displacement = -inverse * K / force;
  const Eigen::MatrixXd by_velocity = -inverse * relative.projected(damping) / (force * scales.time);
  std::vector<Eigen::VectorXd> forces = {inverse.col(0)};
  Eigen::RowVectorXd b = Eigen::RowVectorXd::Zero(K.cols());
  if (rows.back.size() > 0) {
    b = rows.back * relative.motions;
    forces.emplace_back(inverse * b.transpose());
  }
  const Eigen::MatrixXd friction = rows.friction * relative.motions;
  for (const auto& row : friction.rowwise()) forces.emplace_back(inverse * row.transpose());
  if (!ripple.harmonics.empty()) {
    const double torque = ripple.mean / scales.force(1.0);
    forces.emplace_back(torque * inverse * (ripple.node * relative.motions).transpose());
  }
  const Eigen::MatrixXd V = reached(forces, {by_displacement, by_velocity});
  return {.mass = V.transpose() * mass * V,
          .by_force = V.transpose() * inverse.col(0),
          .by_back_force = -V.transpose() * inverse * b.transpose(),
          .by_displacement = V.transpose() * by_displacement * V,
          .by_velocity = V.transpose() * by_velocity * V,
          .back = b * V,
          .friction = friction * V,
          .by_ripple = ripple.harmonics.empty() ? Eigen::VectorXd() : Eigen::VectorXd(V.transpose() * forces.back()),
          .harmonics = ripple.harmonics};
}

}  // namespace gearfilm

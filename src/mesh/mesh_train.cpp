#include "mesh/mesh_train.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/dense.hpp"

namespace gearfilm {

namespace {

/// Of each mode, whether rows of q by which something acts on the motion reach it, directly or by dampers and by what
/// of the stiffness is not symmetric. Modes do not depend on the speed, so that neither does what is reached.
std::vector<bool> reached_modes(const DampedTrain& damped, const std::vector<Eigen::RowVectorXd>& rows) {
  constexpr double round_off = 1e-9;
  const auto count = static_cast<Eigen::Index>(damped.modes.size());
  Eigen::MatrixXd shapes(damped.train.freedoms(), count);
  for (Eigen::Index n = 0; n < count; ++n) shapes.col(n) = damped.modes[static_cast<std::size_t>(n)].shape;
  std::vector<bool> reached(damped.modes.size(), false);
  const auto reach = [&](const Eigen::RowVectorXd& parts, double whole) {
    bool more = false;
    for (Eigen::Index n = 0; n < count; ++n) {
      const auto mode = static_cast<std::size_t>(n);
      if (reached[mode] || std::abs(parts[n]) <= round_off * whole) continue;
      reached[mode] = more = true;
    }
    return more;
  };
  for (const Eigen::RowVectorXd& row : rows) {
    const Eigen::RowVectorXd parts = row * shapes;
    reach(parts, parts.norm());
  }
  const Eigen::MatrixXd K = damped.train.stiffness();
  for (bool again = true; again;) {
    again = false;
    for (const Eigen::MatrixXd& matrix : {damped.damping, Eigen::MatrixXd(K - K.transpose())}) {
      const Eigen::MatrixXd parts = shapes.transpose() * matrix * shapes;
      for (Eigen::Index n = 0; n < count; ++n) {
        if (reached[static_cast<std::size_t>(n)] && reach(parts.col(n).transpose(), parts.norm())) again = true;
      }
    }
  }
  return reached;
}

/// An orthonormal basis, e_1 first, of the relative coordinates of those modes: what is left of all where the other
/// modes have no part, v_i^T M y = 0.
Eigen::MatrixXd basis_of(const DampedTrain& damped, const std::vector<bool>& reached) {
  const Eigen::Index size = damped.relative.motions.cols();
  Eigen::MatrixXd beside = Eigen::MatrixXd::Identity(size, 1);
  for (std::size_t n = 0; n < reached.size(); ++n) {
    if (reached[n]) continue;
    beside.conservativeResize(Eigen::NoChange, beside.cols() + 1);
    beside.rightCols(1) =
        (damped.relative.motions.transpose() * (damped.train.mass() * damped.modes[n].shape)).normalized();
  }
  Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(size, size);
  if (beside.cols() == 1) return basis;
  const Eigen::MatrixXd others = orthogonal_complement(beside);
  basis.conservativeResize(Eigen::NoChange, 1 + others.cols());
  basis.rightCols(others.cols()) = others;
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
  Eigen::VectorXd sum = torque_acceleration(path, T);
  sum += by_force * pull + by_back_force * back_force;
  sum += by_displacement.lazyProduct(motion.q) + by_velocity.lazyProduct(motion.v);
  return sum;
}

MeshTrain mesh_train(const std::shared_ptr<const DampedTrain>& damped, const FlankRows& rows,
                     const std::vector<NodeTorque>& torques, const Scales& scales, double pinion_speed) {
  const Train& train = damped->train;
  const RelativeMotion& relative = damped->relative;
  const Eigen::MatrixXd K = relative.projected(train.stiffness());
  // Both sides of the equation over p_h R_x*, so that a mass is as in Scales::inertia.
  const double force = scales.pressure * scales.solids.radius_x;
  const Eigen::MatrixXd mass = relative.projected(train.mass()) / (force * scales.time * scales.time);
  const Eigen::MatrixXd inverse_mass = inverse(mass);
  const Eigen::MatrixXd by_displacement = -inverse_mass * K / force;
  const Eigen::MatrixXd by_velocity = -inverse_mass * relative.projected(damped->damping) / (force * scales.time);
  std::vector<Eigen::RowVectorXd> acting = {train.contacts().row(0)};
  Eigen::RowVectorXd b = Eigen::RowVectorXd::Zero(K.cols());
  if (rows.back.size() > 0) {
    b = rows.back * relative.motions;
    acting.push_back(rows.back);
  }
  Eigen::MatrixXd friction(0, K.cols());
  if (rows.friction.size() > 0) friction = rows.friction * relative.motions;
  for (const auto& row : rows.friction.rowwise()) acting.emplace_back(row);
  for (const NodeTorque& torque : torques) {
    if (torque.accelerates || !torque.harmonics.empty()) acting.push_back(torque.node);
  }
  const Eigen::MatrixXd V = basis_of(*damped, reached_modes(*damped, acting));
  const auto by_moment = [&](double moment, const NodeTorque& torque) -> Eigen::VectorXd {
    return V.transpose() * (moment / scales.force(1.0) * inverse_mass * (torque.node * relative.motions).transpose());
  };
  std::vector<MeshTrain::Ripple> ripples;
  Eigen::VectorXd by_run_up;
  for (const NodeTorque& torque : torques) {
    if (!torque.harmonics.empty()) ripples.push_back({by_moment(torque.mean, torque), torque.harmonics});
    if (torque.accelerates) {
      by_run_up = by_moment(torque_of_run_up(*damped, torque) * pinion_speed / scales.time, torque);
    }
  }
  return {.mass = V.transpose() * mass * V,
          .by_force = V.transpose() * inverse_mass.col(0),
          .by_back_force = -V.transpose() * inverse_mass * b.transpose(),
          .by_displacement = V.transpose() * by_displacement * V,
          .by_velocity = V.transpose() * by_velocity * V,
          .back = b * V,
          .friction = friction * V,
          .ripples = std::move(ripples),
          .by_run_up = std::move(by_run_up),
          .whole = {.damped = damped, .torques = torques, .motions = relative.motions * V}};
}

}  // namespace gearfilm

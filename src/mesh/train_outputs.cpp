#include "mesh/train_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

/// q_0: the other relative coordinates are those of elements, which all resist.
Eigen::VectorXd displacement_at_rest(const WholeTrain& whole) {
  const RelativeMotion& relative = whole.damped->relative;
  const Eigen::MatrixXd K = relative.projected(whole.damped->train.stiffness());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(K.rows());
  for (const NodeTorque& torque : whole.torques) forces += torque.mean * (torque.node * relative.motions).transpose();
  Eigen::VectorXd y = Eigen::VectorXd::Zero(K.rows());
  const Eigen::Index others = K.cols() - 1;
  if (others > 0) y.tail(others) = solved(K.bottomRightCorner(others, others), forces.tail(others));
  return relative.motions * y;
}

/// "shaft motor-pinion" as the name of a column.
std::string column_name(std::string element) {
  std::ranges::replace_if(
      element, [](char c) { return c == ' ' || c == '-'; }, '_');
  return element;
}

}  // namespace

TrainOutputs::TrainOutputs(const MeshModel& mesh) : mesh_(mesh), train_(*mesh.train) {
  const WholeTrain& whole = train_.whole;
  const Train& train = whole.damped->train;
  const auto of_motions = [&](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd {
    return whole.motions.transpose() * matrix * whole.motions;
  };
  at_rest_ = displacement_at_rest(whole);
  rigid_ = whole.damped->relative.rigid;
  if (rigid_.size() > 0) rigid_inertia_ = rigid_.dot(train.mass() * rigid_);
  mass_ = of_motions(train.mass());
  const Eigen::MatrixXd K = of_motions(train.stiffness());
  stiffness_ = 0.5 * (K + K.transpose());
  skew_ = 0.5 * (K - K.transpose());
  dissipation_ = of_motions(whole.damped->damping);
  add_nodes(train);
  first_of_elements_ = list_.size();
  add_elements(train);
}

void TrainOutputs::add(const std::string& name, const std::string& unit, const Eigen::RowVectorXd& by_displacement,
                       const Eigen::RowVectorXd& by_velocity) {
  const auto known = std::ranges::count_if(
      list_, [&](const TrainOutput& one) { return one.name == name || one.name.starts_with(name + "_of_"); });
  list_.push_back({known == 0 ? name : name + "_of_" + std::to_string(known + 1), unit});
  const Eigen::Index rows = by_displacement_.rows();
  for (const auto& [matrix, row] :
       {std::pair{&by_displacement_, &by_displacement}, std::pair{&by_velocity_, &by_velocity}}) {
    matrix->conservativeResize(rows + 1, row->size());
    matrix->bottomRows(1) = *row;
  }
}

void TrainOutputs::add_nodes(const Train& train) {
  const Eigen::RowVectorXd none = Eigen::RowVectorXd::Zero(train.freedoms());
  for (std::size_t n = 0; n < train.node_count(); ++n) {
    const std::string& name = train.node(n).name;
    if (!train.node(n).fixed) {
      add("rotation_" + name, "rad", train.rotation(n), none);
      add("rotation_velocity_" + name, "rad/s", none, train.rotation(n));
    }
    if (!train.node(n).mass) continue;
    const Eigen::MatrixXd place = train.translation(n);
    for (const auto& [axis, row] : {std::pair{"x", 0}, std::pair{"y", 1}}) {
      add(std::string(axis) + "_" + name, "m", place.row(row), none);
      add(std::string(axis) + "_velocity_" + name, "m/s", none, place.row(row));
    }
  }
}

void TrainOutputs::add_elements(const Train& train) {
  for (const TrainElement& element : train.elements()) {
    const Eigen::MatrixXd by_way = element.stiffness * element.rows;
    Eigen::MatrixXd by_rate = Eigen::MatrixXd::Zero(by_way.rows(), by_way.cols());
    if (element.damping.size() > 0) by_rate = element.damping * element.rows;
    const std::string name = column_name(element.name);
    if (by_way.rows() == 1) {
      add(name, "N m", by_way, by_rate);
      continue;
    }
    add(name + "_x", "N", by_way.row(0), by_rate.row(0));
    add(name + "_y", "N", by_way.row(1), by_rate.row(1));
  }
}

TrainOutputs::Swing TrainOutputs::swing(double T) const {
  Swing sum;
  if (rigid_.size() == 0) return sum;
  const double passed = mesh_.path.mesh_periods(T);
  const double frequency = mesh_.mesh_frequency_si() * mesh_.path.course().speed(T);
  for (const NodeTorque& torque : train_.whole.torques) {
    const double share = torque.mean * torque.node.dot(rigid_) / rigid_inertia_;
    for (const TorqueHarmonic& one : torque.harmonics) {
      const double omega = 2.0 * std::numbers::pi * one.cycles * frequency;
      const double angle = 2.0 * std::numbers::pi * one.cycles * passed + one.phase;
      sum.acceleration += share * one.amplitude * std::cos(angle);
      sum.velocity += share * one.amplitude * std::sin(angle) / omega;
      sum.way -= share * one.amplitude * std::cos(angle) / (omega * omega);
    }
  }
  return sum;
}

Eigen::VectorXd TrainOutputs::displacement(const TrainMoment& moment) const {
  Eigen::VectorXd q = at_rest_ + mesh_.scales.thickness * (train_.whole.motions * moment.motion.q);
  if (rigid_.size() > 0) q += swing(moment.T).way * rigid_;
  return q;
}

Eigen::VectorXd TrainOutputs::velocity(const TrainMoment& moment) const {
  Eigen::VectorXd velocity = mesh_.scales.thickness / mesh_.scales.time * (train_.whole.motions * moment.motion.v);
  if (rigid_.size() > 0) velocity += swing(moment.T).velocity * rigid_;
  return velocity;
}

Eigen::VectorXd TrainOutputs::acceleration(const TrainMoment& moment) const {
  const double pull = moment.teeth - moment.damper - mesh_.scales.static_force;
  Eigen::VectorXd of_motion = train_.acceleration(moment.motion, pull, moment.back, mesh_.path, moment.T);
  if (moment.friction.size() > 0) of_motion -= solved(train_.mass, moment.friction);
  const double scale = mesh_.scales.thickness / (mesh_.scales.time * mesh_.scales.time);
  Eigen::VectorXd acceleration = scale * (train_.whole.motions * of_motion);
  if (rigid_.size() > 0) acceleration += swing(moment.T).acceleration * rigid_;
  return acceleration;
}

Eigen::VectorXd TrainOutputs::values(const TrainMoment& moment) const {
  return by_displacement_ * displacement(moment) + by_velocity_ * velocity(moment);
}

Eigen::VectorXd TrainOutputs::rates(const TrainMoment& moment) const {
  return by_displacement_ * velocity(moment) + by_velocity_ * acceleration(moment);
}

TrainPowers TrainOutputs::powers(const TrainMoment& moment) const {
  const Scales& scales = mesh_.scales;
  const Eigen::VectorXd v = scales.thickness / scales.time * moment.motion.v;
  const Eigen::VectorXd y = scales.thickness * moment.motion.q;
  TrainPowers powers{.torques = -scales.force(scales.static_force) * v[0],
                     .teeth = scales.force(moment.teeth) * v[0] - scales.force(moment.back) * train_.back.dot(v),
                     .dampers = v.dot(dissipation_ * v) + v.dot(skew_ * y) + scales.force(moment.damper) * v[0]};
  if (moment.friction.size() > 0) powers.teeth -= scales.force(moment.friction.dot(v));
  const Eigen::VectorXd fluctuating = train_.mass * train_.torque_acceleration(mesh_.path, moment.T);
  powers.torques += scales.force(fluctuating.dot(v));
  return powers;
}

double TrainOutputs::kinetic_energy(const Motion& motion) const {
  const Eigen::VectorXd v = mesh_.scales.thickness / mesh_.scales.time * motion.v;
  return 0.5 * v.dot(mass_ * v);
}

double TrainOutputs::stored_energy(const Motion& motion) const {
  const Eigen::VectorXd y = mesh_.scales.thickness * motion.q;
  return 0.5 * y.dot(stiffness_ * y);
}

}  // namespace gearfilm

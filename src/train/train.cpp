#include "train/train.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

Eigen::Index freedoms_of(const TrainNode& node) { return (node.fixed ? 0 : 1) + (node.mass ? 2 : 0); }

}  // namespace

Train::Train(std::vector<TrainNode> nodes) : nodes_(std::move(nodes)) {
  Eigen::Index count = 0;
  for (const TrainNode& node : nodes_) {
    first_.push_back(count);
    count += freedoms_of(node);
  }
  mass_ = Eigen::MatrixXd::Zero(count, count);
  contacts_.resize(0, count);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Eigen::RowVectorXd phi = rotation(n);
    const Eigen::MatrixXd u = translation(n);
    mass_ += nodes_[n].inertia * phi.transpose() * phi + nodes_[n].mass.value_or(0.0) * u.transpose() * u;
  }
}

std::optional<std::size_t> Train::find(const std::string& name) const {
  const auto found = std::ranges::find(nodes_, name, &TrainNode::name);
  if (found == nodes_.end()) return {};
  return static_cast<std::size_t>(found - nodes_.begin());
}

Eigen::RowVectorXd Train::rotation(std::size_t n) const {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(freedoms());
  if (!nodes_[n].fixed) row[first_[n]] = 1.0;
  return row;
}

Eigen::MatrixXd Train::translation(std::size_t n) const {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, freedoms());
  if (nodes_[n].mass) rows.middleCols(first_[n] + (nodes_[n].fixed ? 0 : 1), 2).setIdentity();
  return rows;
}

Eigen::VectorXd Train::lengths() const {
  Eigen::VectorXd lengths = Eigen::VectorXd::Ones(freedoms());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!nodes_[n].fixed) lengths[first_[n]] = nodes_[n].radius;
  }
  return lengths;
}

void Train::add_shaft(std::size_t a, std::size_t b, const Shaft& shaft) {
  const Eigen::RowVectorXd at_a = rotation(a), at_b = rotation(b);
  elements_.push_back({.name = "shaft " + nodes_[a].name + "-" + nodes_[b].name,
                       .rows = at_a - at_b,
                       .stiffness = Eigen::MatrixXd::Constant(1, 1, shaft.stiffness),
                       .damping = Eigen::MatrixXd::Constant(1, 1, shaft.damping)});
  const Eigen::MatrixXd ends = (Eigen::MatrixXd(2, freedoms()) << at_a, at_b).finished();
  const Eigen::Matrix2d consistent{{2.0, 1.0}, {1.0, 2.0}};
  mass_ += shaft.inertia / 6.0 * ends.transpose() * consistent * ends;
}

void Train::add_bearing(std::size_t n, const Bearing& bearing) {
  elements_.push_back({.name = "bearing " + nodes_[n].name,
                       .rows = translation(n),
                       .stiffness = bearing.stiffness,
                       .damping = bearing.damping,
                       .damping_ratio = bearing.damping_ratio});
}

void Train::add_ground(std::size_t n, double stiffness, double damping) {
  elements_.push_back({.name = "ground " + nodes_[n].name,
                       .rows = rotation(n),
                       .stiffness = Eigen::MatrixXd::Constant(1, 1, stiffness),
                       .damping = Eigen::MatrixXd::Constant(1, 1, damping)});
}

void Train::add_contact(const Eigen::RowVectorXd& row) {
  contacts_.conservativeResize(contacts_.rows() + 1, Eigen::NoChange);
  contacts_.bottomRows(1) = row;
}

Eigen::MatrixXd Train::stiffness() const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(freedoms(), freedoms());
  for (const TrainElement& element : elements_) sum += element.rows.transpose() * element.stiffness * element.rows;
  return sum;
}

Eigen::MatrixXd Train::damping() const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(freedoms(), freedoms());
  for (const TrainElement& element : elements_) {
    if (element.damping.size() > 0) sum += element.rows.transpose() * element.damping * element.rows;
  }
  return sum;
}

}  // namespace gearfilm

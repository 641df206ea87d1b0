#include "train/train_modes.hpp"

#include <cmath>
#include <numbers>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) { return 0.5 * (matrix + matrix.transpose()); }

TrainMode described(const Train& train, std::span<const double> stiffness, double rate, const Eigen::VectorXd& shape) {
  TrainMode mode{.rate = rate, .shape = shape, .mesh_share = 0.0, .element_shares = {}};
  const double energy = rate * rate;
  const Eigen::VectorXd parting = train.contacts() * shape;
  for (Eigen::Index p = 0; p < parting.size(); ++p) {
    mode.mesh_share += stiffness[static_cast<std::size_t>(p)] * parting[p] * parting[p] / energy;
  }
  for (const TrainElement& element : train.elements()) {
    const Eigen::VectorXd way = element.rows * shape;
    mode.element_shares.push_back(way.dot(element.stiffness * way) / energy);
  }
  return mode;
}

}  // namespace

double TrainMode::frequency() const { return rate / (2.0 * std::numbers::pi); }

std::vector<TrainMode> train_modes(const Train& train, const RelativeMotion& relative,
                                   std::span<const double> stiffness) {
  Eigen::MatrixXd K = symmetric_part(train.stiffness());
  for (std::size_t p = 0; p < stiffness.size(); ++p) {
    const auto row = train.contacts().row(static_cast<Eigen::Index>(p));
    K += stiffness[p] * row.transpose() * row;
  }
  const SymmetricEigenPairs eigen = symmetric_eigen_pairs(relative.projected(K), relative.projected(train.mass()));
  std::vector<TrainMode> modes;
  for (Eigen::Index n = 0; n < eigen.values.size(); ++n) {
    modes.push_back(described(train, stiffness, std::sqrt(std::max(0.0, eigen.values[n])),
                              relative.motions * eigen.vectors.col(n)));
  }
  return modes;
}

Eigen::VectorXd normalised_shape(const Train& train, const TrainMode& mode) {
  Eigen::VectorXd shape = mode.shape.cwiseProduct(train.lengths());
  Eigen::Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  return shape / shape[largest];
}

}  // namespace gearfilm

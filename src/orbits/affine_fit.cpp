#include "orbits/affine_fit.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"

namespace gearfilm {

AffineFit::AffineFit(const std::vector<Return>& returns) {
  for (const Return& one : returns) scale_ = std::max(scale_, length(one.from));
  const auto count = static_cast<Eigen::Index>(returns.size());
  const auto unknowns = static_cast<Eigen::Index>(AffineFit::unknowns(returns.front().to));
  Eigen::MatrixXd X(count, unknowns), y(count, unknowns - 1);
  for (Eigen::Index n = 0; n < count; ++n) {
    X.row(n) << to_vector(returns[n].from).transpose(), scale_;
    y.row(n) = to_vector(returns[n].to).transpose();
  }
  inverse_ = inverse(X.transpose() * X);
  solution_ = inverse_ * (X.transpose() * y);
  const Eigen::Index spare = count - unknowns;
  variance_ = Eigen::VectorXd::Zero(unknowns - 1);
  if (spare > 0) variance_ = (y - X * solution_).colwise().squaredNorm().transpose() / static_cast<double>(spare);
}

Motion AffineFit::fixed_point() const {
  const Eigen::Index size = solution_.cols();
  return to_motion(solved(Monodromy::Identity(size, size) - map(), scale_ * solution_.row(size).transpose()));
}

double AffineFit::deviation(const std::complex<double>& mu) const {
  const EigenPairs eigen = eigen_pairs(map());
  const Eigen::Index size = solution_.cols();
  Eigen::Index n = 0;
  (eigen.values.array() - mu).abs().minCoeff(&n);
  const Eigen::VectorXcd v = eigen.vectors.col(n);
  const Eigen::RowVectorXcd w = eigen.left.row(n);
  const double spread = v.dot(inverse_.topLeftCorner(size, size) * v).real();
  return std::sqrt(w.cwiseAbs2().dot(variance_) * spread);
}

}  // namespace gearfilm

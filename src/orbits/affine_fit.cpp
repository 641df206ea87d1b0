#include "orbits/affine_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

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
  inverse_ = (X.transpose() * X).inverse();
  solution_ = inverse_ * (X.transpose() * y);
  const Eigen::Index spare = count - unknowns;
  variance_ = Eigen::VectorXd::Zero(unknowns - 1);
  if (spare > 0) variance_ = (y - X * solution_).colwise().squaredNorm().transpose() / static_cast<double>(spare);
}

Motion AffineFit::fixed_point() const {
  const Eigen::Index size = solution_.cols();
  return to_motion((Monodromy::Identity(size, size) - map()).inverse() * (scale_ * solution_.row(size).transpose()));
}

double AffineFit::deviation(const std::complex<double>& mu) const {
  const Eigen::EigenSolver<Monodromy> eigen(map());
  if (eigen.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Index size = solution_.cols();
  Eigen::Index n = 0;
  (eigen.eigenvalues().array() - mu).abs().minCoeff(&n);
  const Eigen::MatrixXcd vectors = eigen.eigenvectors();
  const Eigen::VectorXcd v = vectors.col(n);
  const Eigen::RowVectorXcd w = vectors.inverse().row(n);  // w.v = 1
  const double spread = v.dot(inverse_.topLeftCorner(size, size) * v).real();
  return std::sqrt(w.cwiseAbs2().dot(variance_) * spread);
}

}  // namespace gearfilm

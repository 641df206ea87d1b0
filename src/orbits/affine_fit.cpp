#include "gearfilm/orbits/affine_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gearfilm {

AffineFit::AffineFit(const std::vector<Return>& returns) {
  for (const Return& one : returns) scale_ = std::max(scale_, length(one.from));
  const auto count = static_cast<Eigen::Index>(returns.size());
  Eigen::MatrixX3d X(count, 3);
  Eigen::MatrixX2d y(count, 2);
  for (Eigen::Index n = 0; n < count; ++n) {
    X.row(n) << returns[n].from.H0, returns[n].from.V0, scale_;
    y.row(n) << returns[n].to.H0, returns[n].to.V0;
  }
  inverse_ = (X.transpose() * X).inverse();
  solution_ = inverse_ * (X.transpose() * y);
  const double spare = static_cast<double>(count) - 3.0;
  if (spare > 0.0) variance_ = (y - X * solution_).colwise().squaredNorm() / spare;
}

Motion AffineFit::fixed_point() const {
  return to_motion((Monodromy::Identity() - map()).inverse() * (scale_ * solution_.row(2).transpose()));
}

double AffineFit::deviation(const std::complex<double>& mu) const {
  const Eigen::EigenSolver<Monodromy> eigen(map());
  if (eigen.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  Eigen::Index n = 0;
  (eigen.eigenvalues().array() - mu).abs().minCoeff(&n);
  const Eigen::Vector2cd v = eigen.eigenvectors().col(n);
  const Eigen::RowVector2cd w = eigen.eigenvectors().inverse().row(n);  // w.v = 1
  const double spread = v.dot(inverse_.topLeftCorner<2, 2>() * v).real();
  return std::sqrt(w.cwiseAbs2().dot(variance_) * spread);
}

}  // namespace gearfilm

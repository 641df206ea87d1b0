#include "numerics/anderson_mixing.hpp"

#include <numeric>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

constexpr double regularity = 1e-10;  // of the least squares, relative

std::vector<double> minus(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a);
  for (std::size_t n = 0; n < a.size(); ++n) difference[n] -= b[n];
  return difference;
}

double own_product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

void AndersonMixing::restart() {
  differences_.clear();
  last_x_.clear();
  last_f_.clear();
}

std::vector<double> AndersonMixing::change(const std::vector<double>& x, const std::vector<double>& f) {
  if (!last_x_.empty()) differences_.push_back({minus(x, last_x_), minus(f, last_f_)});
  if (differences_.size() > static_cast<std::size_t>(depth_)) differences_.pop_front();
  last_x_ = x;
  last_f_ = f;
  const auto count = static_cast<Eigen::Index>(differences_.size());
  // Normal equations, and their right side as the last column.
  Eigen::MatrixXd products(count, count + 1);
  for (Eigen::Index j = 0; j < count; ++j) {
    for (Eigen::Index k = 0; k < count; ++k) products(j, k) = own_product(differences_[j].f, differences_[k].f);
    products(j, count) = own_product(differences_[j].f, f);
  }
  MPI_Allreduce(MPI_IN_PLACE, products.data(), static_cast<int>(products.size()), MPI_DOUBLE, MPI_SUM, comm_);
  Eigen::MatrixXd matrix = products.leftCols(count);
  const double trace = matrix.trace();
  std::vector<double> change(f);
  for (double& value : change) value *= relaxation_;
  if (trace == 0.0) return change;
  matrix.diagonal().array() += regularity * trace;
  const Eigen::VectorXd c = solved(matrix, products.col(count));
  for (Eigen::Index j = 0; j < count; ++j) {
    for (std::size_t n = 0; n < change.size(); ++n) {
      change[n] -= c[j] * (differences_[j].x[n] + relaxation_ * differences_[j].f[n]);
    }
  }
  return change;
}

}  // namespace gearfilm

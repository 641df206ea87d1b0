#include "gearfilm/parallel/anderson_mixing.hpp"

#include <numeric>

#include "gearfilm/parallel/dense_factors.hpp"

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
  const std::size_t count = differences_.size();
  // Normal equations, and their right side as the last column.
  std::vector<double> products(count * (count + 1));
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t k = 0; k < count; ++k) {
      products[j * (count + 1) + k] = own_product(differences_[j].f, differences_[k].f);
    }
    products[j * (count + 1) + count] = own_product(differences_[j].f, f);
  }
  MPI_Allreduce(MPI_IN_PLACE, products.data(), static_cast<int>(products.size()), MPI_DOUBLE, MPI_SUM, comm_);
  std::vector<double> matrix, right_side;
  double trace = 0.0;
  for (std::size_t j = 0; j < count; ++j) trace += products[j * (count + 1) + j];
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t k = 0; k < count; ++k) {
      matrix.push_back(products[j * (count + 1) + k] + (j == k ? regularity * trace : 0.0));
    }
    right_side.push_back(products[j * (count + 1) + count]);
  }
  std::vector<double> change(f);
  for (double& value : change) value *= relaxation_;
  if (trace == 0.0) return change;
  DenseFactors factors;
  factors.factor(matrix);
  const std::vector<double> c = factors.solve(right_side);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t n = 0; n < change.size(); ++n) {
      change[n] -= c[j] * (differences_[j].x[n] + relaxation_ * differences_[j].f[n]);
    }
  }
  return change;
}

}  // namespace gearfilm

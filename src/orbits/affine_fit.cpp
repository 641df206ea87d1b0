#include "gearfilm/orbits/affine_fit.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

AffineFit::AffineFit(const std::vector<Return>& returns) {
  for (const Return& one : returns) scale_ = std::max(scale_, length(one.from));
  for (const Return& one : returns) {
    const std::array<double, 3> x = columns(one);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) inverse_[3 * i + j] += x[i] * x[j];
      right_[0][i] += x[i] * one.to.H0;
      right_[1][i] += x[i] * one.to.V0;
    }
  }
  invert();
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) solution_[row][i] += inverse_[3 * i + j] * right_[row][j];
    }
  }
  const double spare = static_cast<double>(returns.size()) - 3.0;
  if (spare <= 0.0) return;
  for (const Return& one : returns) {
    const std::array<double, 3> x = columns(one);
    for (int row = 0; row < 2; ++row) {
      double rest = row == 0 ? one.to.H0 : one.to.V0;
      for (int i = 0; i < 3; ++i) rest -= x[i] * solution_[row][i];
      variance_[row] += rest * rest / spare;
    }
  }
}

Motion AffineFit::fixed_point() const {
  const auto& [a, b] = map();
  const double p = scale_ * solution_[0][2], q = scale_ * solution_[1][2];
  const double determinant = (1.0 - a[0]) * (1.0 - b[1]) - a[1] * b[0];
  return {((1.0 - b[1]) * p + a[1] * q) / determinant, (b[0] * p + (1.0 - a[0]) * q) / determinant};
}

double AffineFit::deviation(const std::complex<double>& mu) const {
  using Vector = std::array<std::complex<double>, 2>;
  const Monodromy m = map();
  const auto null_vector = [&](double a, double b, double c, double d) {
    const Vector first = {b, mu - a}, second = {mu - d, c};
    const auto size = [](const Vector& of) { return std::norm(of[0]) + std::norm(of[1]); };
    return size(first) > size(second) ? first : second;
  };
  const Vector v = null_vector(m[0][0], m[0][1], m[1][0], m[1][1]);
  const Vector w = null_vector(m[0][0], m[1][0], m[0][1], m[1][1]);
  double spread = 0.0;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) spread += inverse_[3 * i + j] * std::real(std::conj(v[i]) * v[j]);
  }
  const double rows = std::norm(w[0]) * variance_[0] + std::norm(w[1]) * variance_[1];
  return std::sqrt(rows * spread / std::norm(w[0] * v[0] + w[1] * v[1]));
}

void AffineFit::invert() {
  const std::array<double, 9> a = inverse_;
  const auto cofactor = [&](int i, int j) {
    const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
    return a[3 * k + m] * a[3 * l + n] - a[3 * k + n] * a[3 * l + m];
  };
  const double determinant = a[0] * cofactor(0, 0) + a[1] * cofactor(0, 1) + a[2] * cofactor(0, 2);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inverse_[3 * i + j] = cofactor(j, i) / determinant;
  }
}

}  // namespace gearfilm

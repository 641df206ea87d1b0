// How the solids beneath some films give way: film k is displaced by
//
//   H_k = H_0 + sum_j c_kj F_j ,   F_j = Int Int P_j dX dY
// with H_0 common to all of them. Films whose forces fall by S_k H_k from Z_k are then under the forces
//   (I + S C) F = Z - S H_0 .
#pragma once

#include <span>
#include <vector>

namespace gearfilm {

class Compliance {
public:
  /// Rigid.
  Compliance() = default;
  /// c_kj, row by row: symmetric, c_kk >= c_kj >= 0.
  explicit Compliance(std::vector<double> matrix);

  bool rigid() const { return matrix_.empty(); }
  /// A film is displaced by the force on another.
  bool coupled() const;
  double operator()(std::size_t k, std::size_t j) const { return rigid() ? 0.0 : matrix_[k * films_ + j]; }
  /// Film k by itself.
  Compliance alone(std::size_t k) const;

  /// H_k.
  std::vector<double> displacements(double H0, std::span<const double> forces) const;
  /// I + S C, row by row.
  std::vector<double> coupling_matrix(std::span<const double> stiffness) const;

private:
  std::vector<double> matrix_;
  std::size_t films_ = 0;
};

}  // namespace gearfilm

// How the solids beneath some films give way: film k is displaced by
//
//   H_k = H_0k + sum_j c_kj F_j ,   F_j = Int Int P_j dX dY
// with H_0k the displacement of the bodies (body_equations.hpp). Films whose forces fall by S_k H_k from Z_k are then
// under the forces
//   (I + S C) F = Z - S H_0 .
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace gearfilm {

class Compliance {
public:
  /// Rigid.
  Compliance() = default;
  /// c_kj, n x n: symmetric, c_kk >= c_kj >= 0.
  explicit Compliance(Eigen::MatrixXd matrix);

  bool rigid() const { return matrix_.size() == 0; }
  /// A film is displaced by the force on another.
  bool coupled() const;
  double operator()(std::size_t k, std::size_t j) const { return rigid() ? 0.0 : matrix_(k, j); }
  /// Film k by itself.
  Compliance alone(std::size_t k) const;

  /// H_k of all films, or their changes, from those of H_0k and F_k.
  Eigen::VectorXd displacements(const Eigen::VectorXd& rigid_part, const Eigen::VectorXd& forces) const;
  /// H_k of all films where the bodies displace all of them by one H_0, from the forces F_k.
  std::vector<double> displacements(double H0, std::span<const double> forces) const;
  /// I + S C of stiffnesses S_k, real or complex.
  template <class Scalar>
  Eigen::MatrixX<Scalar> coupling_matrix(const Eigen::VectorX<Scalar>& stiffness) const {
    Eigen::MatrixX<Scalar> matrix = Eigen::MatrixX<Scalar>::Identity(stiffness.size(), stiffness.size());
    if (!rigid()) matrix += stiffness.asDiagonal() * matrix_.cast<Scalar>();
    return matrix;
  }

private:
  Eigen::MatrixXd matrix_;  ///< C; empty where rigid
};

}  // namespace gearfilm

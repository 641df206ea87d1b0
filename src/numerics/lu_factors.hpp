// LU factors of small dense matrices, which every process computes for itself.
#pragma once

#include <Eigen/LU>
#include <limits>

namespace gearfilm {

/// Factors of a square matrix. Those of a singular one are not numbers, and neither is what is solved with them, which
/// PETSc's solvers take for a failed solution.
template <class Derived>
auto lu_factors(const Eigen::MatrixBase<Derived>& matrix) {
  using Matrix = typename Derived::PlainObject;
  constexpr typename Derived::Scalar none = std::numeric_limits<double>::quiet_NaN();
  Eigen::PartialPivLU<Matrix> factors(matrix);
  if (factors.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) {
    factors.compute(Matrix::Constant(matrix.rows(), matrix.cols(), none));
  }
  return factors;
}

}  // namespace gearfilm

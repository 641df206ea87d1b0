// Linear algebra of small dense matrices, which every process computes for itself: those decompositions of Eigen that
// take long to compile are compiled here, once.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace gearfilm {

/// Factors of a square matrix. Those of a singular one are not numbers, and neither is what is solved with them, which
/// PETSc's solvers take for a failed solution.
class LuFactors {
public:
  LuFactors() = default;
  explicit LuFactors(const Eigen::MatrixXd& matrix);

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// A^-1 b; not numbers where A is singular.
Eigen::VectorXd solved(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
Eigen::VectorXcd solved_complex(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b);
Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);
double determinant(const Eigen::MatrixXd& A);

/// The x with the least |A x - b|.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Orthonormal columns that, with those of A, span everything: as many as A has rows, less its rank.
Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& A);

/// The unit vector v with the least |A v|.
Eigen::VectorXd nearest_to_kernel(const Eigen::MatrixXd& A);

/// A v_n = lambda_n v_n, the v_n as columns. Rows of the inverse of the vectors are left eigenvectors w_n with
/// w_n v_n = 1. Not numbers where they were not found.
struct EigenPairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors, left;
};
EigenPairs eigen_pairs(const Eigen::MatrixXd& A);

/// K v_n = lambda_n M v_n of symmetric matrices, M positive definite, by rising lambda_n; v_n^T M v_n = 1.
struct SymmetricEigenPairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigenPairs symmetric_eigen_pairs(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

}  // namespace gearfilm

#include "algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <limits>

namespace gearfilm {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class Matrix>
Eigen::PartialPivLU<Matrix> factors_of(const Matrix& matrix) {
  Eigen::PartialPivLU<Matrix> factors(matrix);
  if (matrix.size() > 0 && factors.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) {
    factors.compute(Matrix::Constant(matrix.rows(), matrix.cols(), not_a_number));
  }
  return factors;
}

}  // namespace

LuFactors::LuFactors(const Eigen::MatrixXd& matrix) : factors_(factors_of(matrix)) {}

Eigen::VectorXd LuFactors::solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }

Eigen::MatrixXd LuFactors::solve_columns(const Eigen::MatrixXd& right) const { return factors_.solve(right); }

Eigen::VectorXd solved(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) { return factors_of(A).solve(b); }

Eigen::VectorXcd solved_complex(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) { return factors_of(A).solve(b); }

Eigen::MatrixXd inverse(const Eigen::MatrixXd& A) { return factors_of(A).inverse(); }

double determinant(const Eigen::MatrixXd& A) { return A.determinant(); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(A).solve(b);
}

Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& A) {
  if (A.cols() == 0) return Eigen::MatrixXd::Identity(A.rows(), A.rows());
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(A);
  const Eigen::MatrixXd whole = factors.householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.rows());
  return whole.rightCols(A.rows() - factors.rank());
}

Eigen::VectorXd nearest_to_kernel(const Eigen::MatrixXd& A) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(A, Eigen::ComputeFullV).matrixV().rightCols(1);
}

EigenPairs eigen_pairs(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(A);
  if (eigen.info() != Eigen::Success) {
    const Eigen::MatrixXcd none = Eigen::MatrixXcd::Constant(A.rows(), A.cols(), not_a_number);
    return {none.diagonal(), none, none};
  }
  const Eigen::MatrixXcd vectors = eigen.eigenvectors();
  return {eigen.eigenvalues(), vectors, vectors.partialPivLu().inverse()};
}

SymmetricEigenPairs symmetric_eigen_pairs(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K, M);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace gearfilm

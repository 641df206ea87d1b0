// Small dense matrices: eigenvectors from both sides, directions that columns miss, singular matrices.
#include "algebra/dense.hpp"

#include <gmock/gmock.h>

namespace gearfilm {
namespace {

// One eigenvalue is real, two are a complex pair.
const Eigen::MatrixXd turning{{0.6, -0.9, 0.1}, {0.9, 0.6, 0.2}, {0.0, 0.3, -1.4}};

TEST(EigenPairs, have_vectors_from_both_sides) {
  const EigenPairs eigen = eigen_pairs(turning);
  const Eigen::MatrixXcd A = turning, values = eigen.values.asDiagonal();
  EXPECT_LT((A * eigen.vectors - eigen.vectors * values).norm(), 1e-14);
  EXPECT_LT((eigen.left * A - values * eigen.left).norm(), 1e-14);
  EXPECT_LT((eigen.left * eigen.vectors - Eigen::MatrixXcd::Identity(3, 3)).norm(), 1e-14);
}

TEST(SymmetricEigenPairs, are_orthonormal_in_the_mass) {
  const Eigen::MatrixXd K{{3.0, -1.0, 0.0}, {-1.0, 2.0, -1.0}, {0.0, -1.0, 5.0}};
  const Eigen::MatrixXd M{{2.0, 0.5, 0.0}, {0.5, 1.0, 0.0}, {0.0, 0.0, 3.0}};
  const SymmetricEigenPairs eigen = symmetric_eigen_pairs(K, M);
  EXPECT_LT((eigen.vectors.transpose() * M * eigen.vectors - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-14);
  const Eigen::MatrixXd values = eigen.vectors.transpose() * K * eigen.vectors;
  EXPECT_LT((values - Eigen::MatrixXd(eigen.values.asDiagonal())).norm(), 1e-14);
  EXPECT_LT(eigen.values[0], eigen.values[1]);
}

TEST(OrthogonalComplement, is_what_columns_miss) {
  Eigen::MatrixXd columns(4, 3);
  columns << 1.0, 2.0, 0.0, 0.0, 1.0, 1.0, 3.0, 6.0, 0.0, -1.0, 0.0, 2.0;
  columns.col(2) = columns.col(0) - 2.0 * columns.col(1);  // of rank two
  const Eigen::MatrixXd others = orthogonal_complement(columns);
  ASSERT_EQ(others.cols(), 2);
  EXPECT_LT((columns.transpose() * others).norm(), 1e-14);
  EXPECT_LT((others.transpose() * others - Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-14);
  EXPECT_EQ(orthogonal_complement(Eigen::MatrixXd(3, 0)).cols(), 3);
}

TEST(NearestToKernel, is_the_direction_that_a_matrix_nearly_forgets) {
  const Eigen::Vector3d v = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
  const Eigen::MatrixXd A = turning - (turning * v - Eigen::Vector3d(0.0, 1e-9, 0.0)) * v.transpose();
  EXPECT_NEAR(std::abs(nearest_to_kernel(A).dot(v)), 1.0, 1e-14);
}

TEST(LeastSquares, fit_a_line) {
  const Eigen::MatrixXd A{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}};
  const Eigen::VectorXd line = least_squares(A, Eigen::Vector3d(1.0, 2.0, 6.0));
  EXPECT_LT((line - Eigen::Vector2d(0.5, 2.5)).norm(), 1e-14);
}

TEST(LuFactors, of_a_singular_matrix_are_no_numbers) {
  const Eigen::Vector2d ones = Eigen::Vector2d::Ones();
  const Eigen::MatrixXd singular{{0.0, 0.0}, {1.0, 2.0}}, plain{{2.0, 0.0}, {0.0, 4.0}};
  EXPECT_THAT(solved(singular, ones), testing::Each(testing::IsNan()));
  EXPECT_THAT(LuFactors(singular).solve(ones), testing::Each(testing::IsNan()));
  EXPECT_EQ(solved(plain, ones), Eigen::VectorXd(Eigen::Vector2d(0.5, 0.25)));
  EXPECT_EQ(inverse(plain), (Eigen::MatrixXd{{0.5, 0.0}, {0.0, 0.25}}));
  EXPECT_EQ(determinant(plain), 8.0);
}

}  // namespace
}  // namespace gearfilm

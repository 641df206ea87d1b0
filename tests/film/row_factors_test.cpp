// LU factors of the matrices of rows.
#include "film/row_factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "placed_film.hpp"

namespace gearfilm {
namespace {

/// Noise but for a diagonal of zeros, so that rows have to be interchanged: element (i, k). Of the first 30 columns
/// only about the diagonal, where there are so many.
double element(int i, int k) {
  constexpr int nearby = 5, local = 30;
  return i == k || (k < local && std::abs(i - k) > nearby) ? 0.0 : noise(i + 1, 7 * k);
}

/// Up to a tolerance of the right side, relative to the solution: the condition of the matrix is of no account.
template <class Real>
void expect_solved(int size, double tolerance) {
  const std::size_t stride = RowFactors<Real>::stride(size);
  std::vector<Real> matrix(RowFactors<Real>::entries(size)), right(stride, Real(0));
  for (int k = 0; k < size; ++k) {
    right[k] = static_cast<Real>(1.0 + noise(k, 3));
    for (int i = 0; i < size; ++i) matrix[k * stride + i] = static_cast<Real>(element(i, k));
  }
  std::vector<Real> left(right);
  const Real behind = right[size] = Real(7);
  RowFactors<Real> factors;
  factors.compute(matrix, size);
  factors.solve(right.data());
  EXPECT_EQ(right[size], behind);
  double largest = 0.0;
  for (int k = 0; k < size; ++k) {
    largest = std::max<double>(largest, std::abs(right[k]));
    for (int i = 0; i < size; ++i) left[i] -= static_cast<Real>(element(i, k)) * right[k];
  }
  for (int i = 0; i < size; ++i) EXPECT_LT(std::abs(left[i]) / largest, tolerance) << size << " " << i;
}

/// The solution itself, of types whose entries keep their precision.
template <class Real>
void expect_found(int size, double tolerance) {
  const std::size_t stride = RowFactors<Real>::stride(size);
  std::vector<Real> matrix(RowFactors<Real>::entries(size)), x, right(stride, Real(0));
  for (int k = 0; k < size; ++k) {
    x.push_back(static_cast<Real>(1.0 + noise(k, 3)));
    for (int i = 0; i < size; ++i) {
      matrix[k * stride + i] = static_cast<Real>(element(i, k));
      right[i] += matrix[k * stride + i] * x[k];
    }
  }
  RowFactors<Real> factors;
  factors.compute(matrix, size);
  factors.solve(right.data());
  for (int k = 0; k < size; ++k) EXPECT_LT(std::abs(right[k] - x[k]), tolerance) << size << " " << k;
}

// Columns are taken four at a time: every rest, and none.
TEST(RowFactors, solve_matrices_of_any_size) {
  for (const int size : {2, 3, 4, 5, 6, 7, 8, 9, 40, 63, 64}) {
    expect_found<double>(size, 1e-10);
    expect_found<std::complex<double>>(size, 1e-10);
    expect_solved<double>(size, 1e-12);
    expect_solved<std::complex<double>>(size, 1e-12);
    expect_solved<float>(size, 1e-3);
  }
}

TEST(RowFactors, of_a_singular_matrix_are_not_numbers) {
  const std::size_t stride = RowFactors<double>::stride(2);
  std::vector<double> matrix(RowFactors<double>::entries(2)), right(stride, 1.0);
  matrix[0] = 1.0;
  matrix[1] = matrix[stride] = 2.0;
  matrix[stride + 1] = 4.0;
  RowFactors<double> factors;
  factors.compute(matrix, 2);
  factors.solve(right.data());
  EXPECT_FALSE(std::isfinite(right[0]));
  EXPECT_FALSE(std::isfinite(right[1]));
}

}  // namespace
}  // namespace gearfilm

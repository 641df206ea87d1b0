// LU factors of the matrices of rows.
#include "film/row_factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "placed_film.hpp"

namespace gearfilm {
namespace {

/// Noise but for a diagonal of zeros, so that rows have to be interchanged: element (i, k).
double element(int i, int k) { return i == k ? 0.0 : noise(i + 1, 7 * k); }

template <class Real>
void expect_solved(int size, double tolerance) {
  std::vector<Real> matrix, x, right(size, Real(0));
  for (int k = 0; k < size; ++k) {
    x.push_back(static_cast<Real>(1.0 + noise(k, 3)));
    for (int i = 0; i < size; ++i) {
      matrix.push_back(static_cast<Real>(element(i, k)));
      right[i] += matrix.back() * x[k];
    }
  }
  RowFactors<Real> factors;
  factors.compute(matrix, size);
  factors.solve(right);
  for (int k = 0; k < size; ++k) EXPECT_LT(std::abs(right[k] - x[k]), tolerance) << size << " " << k;
}

// Columns are taken four at a time: every rest, and none.
TEST(RowFactors, solve_matrices_of_any_size) {
  for (const int size : {2, 3, 4, 5, 6, 7, 8, 9, 63, 64}) {
    expect_solved<double>(size, 1e-10);
    expect_solved<std::complex<double>>(size, 1e-10);
    expect_solved<float>(size, 1e-2);
  }
}

TEST(RowFactors, of_a_singular_matrix_are_not_numbers) {
  std::vector<double> matrix = {1.0, 2.0, 2.0, 4.0}, right = {1.0, 1.0};
  RowFactors<double> factors;
  factors.compute(matrix, 2);
  factors.solve(right);
  EXPECT_FALSE(std::isfinite(right[0]));
  EXPECT_FALSE(std::isfinite(right[1]));
}

}  // namespace
}  // namespace gearfilm

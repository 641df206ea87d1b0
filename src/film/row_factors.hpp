// LU factors of a dense matrix, stored in the order in which its solves read them.
//
// The matrix of a row has a hundred unknowns and more, and is solved tens of times for each time it is factored. A
// solve reads L and U once, so that memory decides how long it takes: L lies column by column from the first to the
// last, U from the last to the first, without their zeros. Rows are interchanged by the largest entry of a column.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace gearfilm {

template <class Real>
class RowFactors {
public:
  /// Factors a square matrix, which is given column by column and overwritten. Factors of a singular one are not
  /// numbers.
  void compute(std::span<Real> matrix, int size);

  /// x = matrix^-1 x
  void solve(std::span<Real> x) const;

private:
  /// Subtracts from a column below its diagonal what the first `columns` columns of L eliminate.
  void eliminate(Real* column, int columns) const;
  /// Where column k of L has its entry of row i: for i = k + 1 .. size_ - 1.
  const Real* lower(int k) const { return lower_.data() + lower_begin(k); }
  std::ptrdiff_t lower_begin(int k) const {
    return static_cast<std::ptrdiff_t>(k) * size_ - static_cast<std::ptrdiff_t>(k) * (k + 1) / 2 - (k + 1);
  }

  int size_ = 0;
  std::vector<Real> lower_;
  std::vector<Real> upper_;           ///< above the diagonal
  std::vector<Real> inverse_pivots_;  ///< 1 / the diagonal of U
  std::vector<int> swapped_;          ///< row with which row k changes places before column k is eliminated
};

extern template class RowFactors<float>;
extern template class RowFactors<double>;
extern template class RowFactors<std::complex<double>>;

}  // namespace gearfilm

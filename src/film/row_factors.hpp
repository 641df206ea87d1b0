// LU factors of a dense matrix, in single precision for solves that need three digits: those of a preconditioner.
//
// The matrix of a row has a hundred unknowns and more, and is solved tens of times for each time it is factored. A
// solve reads L and U once, so that memory decides how long it takes: they lie in the order in which solves read them,
// without their zeros, and entries of single precision in 16 bits, relative to the largest of four columns. Rows are
// interchanged by the largest entry of a column. Where the first columns of a matrix have entries about the diagonal
// alone, those of L have so too, and those of U among them.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace gearfilm {

template <class Real>
class RowFactors {
public:
  /// From one column of the given matrix to the next: columns end with entries that are of no account.
  static std::size_t stride(int size) { return static_cast<std::size_t>(size) + tile; }
  /// Numbers that a given matrix takes in memory: behind its own columns lie a few whose entries do not matter, but
  /// must be finite.
  static std::size_t entries(int size) { return stride(size) * (size + together); }

  /// Factors a square matrix, which is given column by column and overwritten. Factors of a singular one are not
  /// numbers.
  void compute(std::span<Real> matrix, int size);

  /// x = matrix^-1 x for `stride` values, of which those behind the unknowns stay what they are, and are numbers.
  void solve(Real* x) const;

private:
  static constexpr int together = 4;  ///< columns that are changed, and that change others, at once
  static constexpr int panel = 8;     ///< columns that are eliminated from all behind them at once
  /// Entries of a column that are changed at once.
  static constexpr int tile = std::max(panel, 64 / static_cast<int>(sizeof(Real)));

  /// An entry of L or U over their scale.
  using Entry = std::conditional_t<std::is_same_v<Real, float>, std::int16_t, Real>;

  /// Four columns of L and U about the diagonal. Behind the last unknown: those of the unit matrix.
  struct Columns {
    std::array<std::array<Real, together>, together> triangles{};  ///< [column][row], L below the diagonal
    std::array<Real, together> inverse_pivots{};                   ///< 1 / the diagonal of U
    Real lower_scale{}, upper_scale{};
    int lower_end = 0;    ///< row from which on L has zeros only
    int upper_begin = 0;  ///< row up to which U has
  };

  /// The row behind the last one that is not zero in some column from begin to end.
  int end_of_entries(const Real* matrix, int begin, int end) const;
  /// The first row before them that is not zero in some of them.
  int begin_of_entries(const Real* matrix, int begin, int end) const;
  /// Columns of L and U from begin to end, which those before are eliminated from; they end with row `rows`.
  void factor_panel(Real* matrix, int begin, int end, int rows);
  /// Interchanges the rows of all other columns as those of a panel were.
  void interchange_rows(Real* matrix, int begin, int end) const;
  /// Eliminates a whole panel, which ends with row `rows`, from the columns behind it.
  void eliminate_panel(Real* matrix, int begin, int end, int rows) const;
  void keep_triangles(const Real* matrix, int first);
  /// Keeps the entries of rows begin to end of four columns behind those that are there; the scale.
  Real keep(const Real* matrix, int first, int begin, int end, std::vector<Entry>& kept) const;
  static const Entry* subtract(Real* __restrict values, const Entry* __restrict entries, int count,
                               const std::array<Real, together>& factors);

  int size_ = 0;
  std::vector<Columns> columns_;  ///< from the first to the last
  // Beyond the four columns' own rows, [tile of rows][column][row]: L from the first columns to the last, U from the
  // last to the first.
  std::vector<Entry> lower_, upper_;
  std::vector<int> swapped_;  ///< row with which row k changes places before column k is eliminated
};

extern template class RowFactors<float>;
extern template class RowFactors<double>;
extern template class RowFactors<std::complex<double>>;

}  // namespace gearfilm

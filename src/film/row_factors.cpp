#include "film/row_factors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace gearfilm {
namespace {

// Magnitudes as integers of the same order, whose maxima compilers vectorise.
std::int32_t order_of(float value) { return std::bit_cast<std::int32_t>(std::abs(value)); }
std::int64_t order_of(double value) { return std::bit_cast<std::int64_t>(std::abs(value)); }
std::int64_t order_of(std::complex<double> value) { return order_of(std::norm(value)); }

// Without the care for what is not a number that the operator takes for complex ones.
template <class Real>
Real times(Real a, Real b) {
  return a * b;
}
std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

template <class Real>
auto largest_order(const Real* values, int count) {
  auto largest = order_of(Real(0));
  for (int i = 0; i < count; ++i) largest = std::max(largest, order_of(values[i]));
  return largest;
}

/// Subtracts from `tile` rows of four columns the same rows of `count` columns of L times their factors: four factors,
/// one a column, for each column of L.
template <int tile, class Real>
[[gnu::noinline]] void subtract_products(const Real* __restrict l, std::size_t l_stride, const Real* __restrict factors,
                                         int count, Real* __restrict columns, std::size_t stride) {
  Real *c0 = columns, *c1 = c0 + stride, *c2 = c1 + stride, *c3 = c2 + stride;
  Real s0[tile], s1[tile], s2[tile], s3[tile];  // they stay in registers
  std::copy_n(c0, tile, s0);
  std::copy_n(c1, tile, s1);
  std::copy_n(c2, tile, s2);
  std::copy_n(c3, tile, s3);
  for (int p = 0; p < count; ++p, l += l_stride, factors += 4) {
    for (int i = 0; i < tile; ++i) {
      s0[i] -= times(factors[0], l[i]);
      s1[i] -= times(factors[1], l[i]);
      s2[i] -= times(factors[2], l[i]);
      s3[i] -= times(factors[3], l[i]);
    }
  }
  std::copy_n(s0, tile, c0);
  std::copy_n(s1, tile, c1);
  std::copy_n(s2, tile, c2);
  std::copy_n(s3, tile, c3);
}

}  // namespace

template <class Real>
int RowFactors<Real>::end_of_entries(const Real* matrix, int begin, int end) const {
  int rows = end;
  for (int k = begin; k < end; ++k) {
    const Real* column = matrix + k * stride(size_);
    for (int i = size_; i-- > rows;) {
      if (column[i] == Real(0)) continue;
      rows = i + 1;
      break;
    }
  }
  return rows;
}

template <class Real>
int RowFactors<Real>::begin_of_entries(const Real* matrix, int begin, int end) const {
  int first = begin;
  for (int k = begin; k < end; ++k) {
    const Real* column = matrix + k * stride(size_);
    first =
        static_cast<int>(std::find_if(column, column + first, [](Real entry) { return entry != Real(0); }) - column);
  }
  return first;
}

template <class Real>
void RowFactors<Real>::factor_panel(Real* matrix, int begin, int end, int rows) {
  const std::size_t step = stride(size_);
  for (int k = begin; k < end; ++k) {
    Real* __restrict column = matrix + k * step;
    for (int p = begin; p < k; ++p) {
      const Real* __restrict l = matrix + p * step;
      const Real a = column[p];
      for (int i = p + 1; i < rows; ++i) column[i] -= times(a, l[i]);
    }
    const auto most = largest_order(column + k, rows - k);
    int largest = k;
    while (largest < rows - 1 && order_of(column[largest]) != most) ++largest;
    swapped_[k] = largest;
    if (largest != k) {
      for (int p = begin; p < end; ++p) std::swap(matrix[p * step + k], matrix[p * step + largest]);
    }
    const Real inverse = Real(1) / column[k];
    for (int i = k + 1; i < rows; ++i) column[i] *= inverse;
  }
}

template <class Real>
void RowFactors<Real>::interchange_rows(Real* matrix, int begin, int end) const {
  const std::size_t step = stride(size_);
  const auto interchange = [&](int column) {
    Real* values = matrix + column * step;
    for (int k = begin; k < end; ++k) std::swap(values[k], values[swapped_[k]]);
  };
  for (int j = 0; j < begin; ++j) interchange(j);
  for (int j = end; j < size_; ++j) interchange(j);
}

// What the panel's own rows become is their product with the inverse of its triangle.
template <class Real>
void RowFactors<Real>::eliminate_panel(Real* matrix, int begin, int end, int rows) const {
  const std::size_t step = stride(size_);
  std::array<Real, static_cast<std::size_t>(panel) * tile> minus_inverse{};
  for (int p = 0; p < panel; ++p) {
    Real* column = minus_inverse.data() + p * tile;
    column[p] = Real(-1);
    for (int r = p; r < panel; ++r) {
      const Real* l = matrix + (begin + r) * step + begin;
      for (int q = r + 1; q < panel; ++q) column[q] -= column[r] * l[q];
    }
  }
  for (int j = end; j < size_; j += together) {
    Real* columns = matrix + j * step;
    std::array<Real, panel * together> u{};
    std::array<Real, static_cast<std::size_t>(together) * tile> solved{};
    for (int c = 0; c < together; ++c) {
      for (int p = 0; p < panel; ++p) u[p * together + c] = columns[c * step + begin + p];
    }
    subtract_products<tile>(minus_inverse.data(), tile, u.data(), panel, solved.data(), tile);
    for (int c = 0; c < together; ++c) {
      for (int p = 0; p < panel; ++p) {
        u[p * together + c] = columns[c * step + begin + p] = solved[static_cast<std::size_t>(c) * tile + p];
      }
    }
    for (int i = end; i < rows; i += tile) {
      subtract_products<tile>(matrix + begin * step + i, step, u.data(), panel, columns + i, step);
    }
  }
}

template <class Real>
void RowFactors<Real>::keep_triangles(const Real* matrix, int first) {
  Columns& own = columns_.emplace_back();
  own.inverse_pivots.fill(Real(1));
  for (int p = 0; p < std::min(together, size_ - first); ++p) {
    const Real* column = matrix + (first + p) * stride(size_) + first;
    std::copy_n(column, std::min(together, size_ - first), own.triangles[p].begin());
    own.inverse_pivots[p] = Real(1) / column[p];
  }
}

template <class Real>
Real RowFactors<Real>::keep(const Real* matrix, int first, int begin, int end, std::vector<Entry>& kept) const {
  Real scale = Real(1);
  const int columns = std::min(together, size_ - first);
  if constexpr (std::is_same_v<Real, float>) {
    auto largest = order_of(Real(0));
    for (int p = 0; p < columns; ++p) {
      largest = std::max(largest, largest_order(matrix + (first + p) * stride(size_) + begin, end - begin));
    }
    scale = std::max(std::bit_cast<Real>(largest) / Real(32767), std::numeric_limits<Real>::min());
  }
  for (int row = begin; row < end; row += tile) {
    kept.resize(kept.size() + together * tile, Entry(0));
    Entry* out = kept.data() + kept.size() - together * tile;
    for (int p = 0; p < columns; ++p) {
      const Real* column = matrix + (first + p) * stride(size_) + row;
      for (int i = 0; i < std::min(tile, end - row); ++i) {
        if constexpr (std::is_same_v<Real, float>) {
          out[p * tile + i] = static_cast<Entry>(static_cast<int>(std::rint(column[i] / scale)));
        } else {
          out[p * tile + i] = column[i];
        }
      }
    }
  }
  return scale;
}

template <class Real>
void RowFactors<Real>::compute(std::span<Real> matrix, int size) {
  size_ = size;
  swapped_.resize(size);
  for (int begin = 0; begin < size; begin += panel) {
    const int end = std::min(begin + panel, size);
    const int rows = end_of_entries(matrix.data(), begin, end);
    factor_panel(matrix.data(), begin, end, rows);
    interchange_rows(matrix.data(), begin, end);
    if (end < size) eliminate_panel(matrix.data(), begin, end, rows);
  }
  columns_.clear();
  lower_.clear();
  upper_.clear();
  for (int first = 0; first < size; first += together) {
    const int end = std::min(first + together, size);
    keep_triangles(matrix.data(), first);
    Columns& own = columns_.back();
    own.lower_end = end_of_entries(matrix.data(), first, end);
    own.lower_scale = keep(matrix.data(), first, end, own.lower_end, lower_);
  }
  for (int n = static_cast<int>(columns_.size()) - 1; n >= 0; --n) {
    const int first = n * together;
    columns_[n].upper_begin = begin_of_entries(matrix.data(), first, std::min(first + together, size));
    columns_[n].upper_scale = keep(matrix.data(), first, columns_[n].upper_begin, first, upper_);
  }
}

/// Subtracts four columns of L or U times their factors from `count` values, rounded up to whole tiles; returns the
/// entry behind those of these columns.
template <class Real>
auto RowFactors<Real>::subtract(Real* __restrict values, const Entry* __restrict entries, int count,
                                const std::array<Real, together>& factors) -> const Entry* {
  const Real a0 = factors[0], a1 = factors[1], a2 = factors[2], a3 = factors[3];
  for (int begin = 0; begin < count; begin += tile, values += tile, entries += together * tile) {
    for (int i = 0; i < tile; ++i) {
      values[i] -= times(a0, Real(entries[i])) + times(a1, Real(entries[tile + i])) +
                   times(a2, Real(entries[2 * tile + i])) + times(a3, Real(entries[3 * tile + i]));
    }
  }
  return entries;
}

template <class Real>
void RowFactors<Real>::solve(Real* x) const {
  for (int k = 0; k < size_; ++k) std::swap(x[k], x[swapped_[k]]);
  Real* values = x;
  const Entry* entries = lower_.data();
  for (const Columns& own : columns_) {
    const auto& l = own.triangles;
    values[1] -= l[0][1] * values[0];
    values[2] -= l[0][2] * values[0] + l[1][2] * values[1];
    values[3] -= l[0][3] * values[0] + l[1][3] * values[1] + l[2][3] * values[2];
    std::array<Real, together> factors{};
    for (int p = 0; p < together; ++p) factors[p] = own.lower_scale * values[p];
    values += together;
    entries = subtract(values, entries, own.lower_end - static_cast<int>(values - x), factors);
  }
  entries = upper_.data();
  for (auto own = columns_.rbegin(); own != columns_.rend(); ++own) {
    values -= together;
    const auto& u = own->triangles;
    const auto& inverse = own->inverse_pivots;
    values[3] *= inverse[3];
    values[2] = (values[2] - u[3][2] * values[3]) * inverse[2];
    values[1] = (values[1] - u[3][1] * values[3] - u[2][1] * values[2]) * inverse[1];
    values[0] = (values[0] - u[3][0] * values[3] - u[2][0] * values[2] - u[1][0] * values[1]) * inverse[0];
    std::array<Real, together> factors{};
    for (int p = 0; p < together; ++p) factors[p] = own->upper_scale * values[p];
    entries = subtract(x + own->upper_begin, entries, static_cast<int>(values - x) - own->upper_begin, factors);
  }
}

template class RowFactors<float>;
template class RowFactors<double>;
template class RowFactors<std::complex<double>>;

}  // namespace gearfilm

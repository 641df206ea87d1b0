#include "film/row_factors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace gearfilm {
namespace {

constexpr int together = 4;  // columns that are subtracted in one pass over what they change

/// column -= a l
template <class Real>
void subtract(Real* __restrict column, const Real* __restrict l, Real a, int begin, int end) {
  for (int i = begin; i < end; ++i) column[i] -= a * l[i];
}

template <class Real>
void subtract(Real* __restrict column, const Real* __restrict l0, const Real* __restrict l1, const Real* __restrict l2,
              const Real* __restrict l3, const Real* a, int begin, int end) {
  const Real a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3];
  for (int i = begin; i < end; ++i) column[i] -= a0 * l0[i] + a1 * l1[i] + a2 * l2[i] + a3 * l3[i];
}

}  // namespace

template <class Real>
void RowFactors<Real>::eliminate(Real* column, int columns) const {
  int k = 0;
  for (; k + together <= columns; k += together) {
    const Real *l0 = lower(k), *l1 = lower(k + 1), *l2 = lower(k + 2), *l3 = lower(k + 3);
    subtract(column, l0, column[k], k + 1, k + together);
    subtract(column, l1, column[k + 1], k + 2, k + together);
    subtract(column, l2, column[k + 2], k + 3, k + together);
    const Real a[together] = {column[k], column[k + 1], column[k + 2], column[k + 3]};
    subtract(column, l0, l1, l2, l3, a, k + together, size_);
  }
  for (; k < columns; ++k) subtract(column, lower(k), column[k], k + 1, size_);
}

template <class Real>
void RowFactors<Real>::compute(std::span<Real> matrix, int size) {
  size_ = size;
  const auto entries = static_cast<std::size_t>(size) * (size - 1) / 2;
  lower_.resize(entries);
  upper_.resize(entries);
  inverse_pivots_.resize(size);
  swapped_.resize(size);
  for (int k = 0; k < size; ++k) {
    Real* column = matrix.data() + static_cast<std::size_t>(k) * size;
    for (int i = 0; i < k; ++i) std::swap(column[i], column[swapped_[i]]);
    eliminate(column, k);
    int largest = k;
    for (int i = k + 1; i < size; ++i) {
      if (std::abs(column[i]) > std::abs(column[largest])) largest = i;
    }
    swapped_[k] = largest;
    if (largest != k) {
      std::swap(column[k], column[largest]);
      for (int earlier = 0; earlier < k; ++earlier) {
        Real* l = lower_.data() + lower_begin(earlier);
        std::swap(l[k], l[largest]);
      }
    }
    inverse_pivots_[k] = Real(1) / column[k];
    Real* l = lower_.data() + lower_begin(k);
    for (int i = k + 1; i < size; ++i) l[i] = column[i] * inverse_pivots_[k];
  }
  Real* u = upper_.data();
  for (int k = size - 1; k > 0; --k) u = std::copy_n(matrix.data() + static_cast<std::size_t>(k) * size, k, u);
}

template <class Real>
void RowFactors<Real>::solve(std::span<Real> x) const {
  Real* values = x.data();
  for (int k = 0; k < size_; ++k) std::swap(values[k], values[swapped_[k]]);
  eliminate(values, size_);
  const Real* u0 = upper_.data();
  int k = size_ - 1;
  for (; k >= together; k -= together) {
    const Real *u1 = u0 + k, *u2 = u1 + (k - 1), *u3 = u2 + (k - 2);
    const int rest = k - together + 1;  // rows above those of these columns
    Real a[together];
    a[0] = values[k] *= inverse_pivots_[k];
    subtract(values, u0, a[0], rest, k);
    a[1] = values[k - 1] *= inverse_pivots_[k - 1];
    subtract(values, u1, a[1], rest, k - 1);
    a[2] = values[k - 2] *= inverse_pivots_[k - 2];
    subtract(values, u2, a[2], rest, k - 2);
    a[3] = values[k - 3] *= inverse_pivots_[k - 3];
    subtract(values, u0, u1, u2, u3, a, 0, rest);
    u0 = u3 + (k - 3);
  }
  for (; k >= 0; --k) {
    values[k] *= inverse_pivots_[k];
    subtract(values, u0, values[k], 0, k);
    u0 += k;
  }
}

template class RowFactors<float>;
template class RowFactors<double>;
template class RowFactors<std::complex<double>>;

}  // namespace gearfilm

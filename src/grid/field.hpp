// Values of one process on its nodes, with one ghost row on either side in y.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "grid/grid.hpp"

namespace gearfilm {

/// nx lines of y_count values, y contiguous; row(i)[j] with -1 <= j <= y_count. Ghosts are zero until exchanged
/// (halo.hpp) and stay zero beyond ambient edges of the grid.
template <class Real>
class Field {
public:
  explicit Field(const Grid& grid)
      : nx_(grid.nx()), y_count_(grid.y_count()), values_(static_cast<std::size_t>(nx_) * stride(), Real(0)) {}

  int nx() const { return nx_; }
  int y_count() const { return y_count_; }
  int stride() const { return y_count_ + 2; }
  Real* row(int i) { return values_.data() + static_cast<std::size_t>(i) * stride() + 1; }
  const Real* row(int i) const { return values_.data() + static_cast<std::size_t>(i) * stride() + 1; }
  Real* data() { return values_.data(); }
  std::size_t size() const { return values_.size(); }

  /// Copies own nodes from, or to, a compact array of nx*y_count values (the local part of a PETSc vector).
  void load(std::span<const double> compact) {
    for (int i = 0; i < nx_; ++i) std::copy_n(compact.begin() + line_at(i), y_count_, row(i));
  }
  void store(std::span<double> compact) const {
    for (int i = 0; i < nx_; ++i) std::copy_n(row(i), y_count_, compact.begin() + line_at(i));
  }
  void fill(Real value) { std::fill(values_.begin(), values_.end(), value); }

private:
  std::ptrdiff_t line_at(int i) const { return static_cast<std::ptrdiff_t>(i) * y_count_; }

  int nx_;
  int y_count_;
  std::vector<Real> values_;
};

}  // namespace gearfilm

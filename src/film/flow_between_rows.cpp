#include "film/flow_between_rows.hpp"

#include <algorithm>
#include <complex>

#include "lubricant/independent_iterations.hpp"

namespace gearfilm {
namespace {

constexpr int rounds = 6;  // over the even and the odd rows
constexpr double over_relaxation = 1.5;

}  // namespace

template <class Real>
FlowBetweenRows<Real>::Rows::Rows(int first_row, int nx, int y_count)
    : first(first_row), count((y_count - first_row + 1) / 2) {
  const std::size_t size = (nx + lines_before + 1) * (count + 2);
  for (auto* values : {&lower_2, &lower_1, &inverse_pivots, &upper, &south, &north, &right_side, &solved, &change}) {
    values->resize(size);
  }
}

template <class Real>
FlowBetweenRows<Real>::FlowBetweenRows(const Grid& grid, const Halo& halo)
    : halo_(halo), nx_(grid.nx()), rows_{Rows(0, grid.nx(), grid.y_count()), Rows(1, grid.nx(), grid.y_count())} {}

template <class Real>
void FlowBetweenRows<Real>::factor(const FilmStencil<Real>& linear, const Field<PartOf<Real>>& left_out) {
  left_out_.clear();
  for (int i = 0; i < nx_; ++i) {
    const auto v = [&](Neighbour n, int j) { return linear.by_pressure[n].row(i)[j]; };
    for (int j = 0; j < left_out.y_count(); ++j) {
      if (left_out.row(i)[j] != 0.0) left_out_.push_back({i, j, v(west_west, j), v(west, j), v(east, j)});
    }
  }
  for (Rows& own : rows_) {
    for (int i = 0; i < nx_; ++i) {
      const std::size_t here = at(own, i), before = at(own, i - 1), before_2 = at(own, i - 2);
      std::array<const Real*, neighbour_count> v{};
      for (int n = 0; n < neighbour_count; ++n) v[n] = linear.by_pressure[n].row(i) + own.first;
      for (int m = 0; m < own.count; ++m) {
        const int j = 2 * m;
        const Real lower_2 = v[west_west][j] * own.inverse_pivots[before_2 + m];
        const Real lower_1 = (v[west][j] - lower_2 * own.upper[before_2 + m]) * own.inverse_pivots[before + m];
        own.lower_2[here + m] = lower_2;
        own.lower_1[here + m] = lower_1;
        own.inverse_pivots[here + m] = Real(1) / (v[centre][j] - lower_1 * own.upper[before + m]);
        own.upper[here + m] = v[east][j];
        own.south[here + m] = v[south][j];
        own.north[here + m] = v[north][j];
      }
    }
  }
}

// The neighbours of the even row 2m are the odd rows m - 1 and m of their list, those of the odd row 2m + 1 the even
// ones m and m + 1.
template <class Real>
void FlowBetweenRows<Real>::relax(Rows& own, const Rows& others) {
  const int count = own.count, to_south = own.first - 1, to_north = own.first;
  for (int i = 0; i < nx_; ++i) {
    const std::size_t here = at(own, i);
    const Real* other = &others.change[at(others, i)];
    const Real *south = &own.south[here], *north = &own.north[here], *right_side = &own.right_side[here];
    const Real *lower_1 = &own.lower_1[here], *lower_2 = &own.lower_2[here];
    const Real *before = &own.solved[at(own, i - 1)], *before_2 = &own.solved[at(own, i - 2)];
    Real* solved = &own.solved[here];
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int m = 0; m < count; ++m) {
      solved[m] = right_side[m] - south[m] * other[m + to_south] - north[m] * other[m + to_north] -
                  lower_1[m] * before[m] - lower_2[m] * before_2[m];
    }
  }
  for (int i = nx_ - 1; i >= 0; --i) {
    const std::size_t here = at(own, i);
    const Real *upper = &own.upper[here], *inverse_pivot = &own.inverse_pivots[here];
    const Real* after = &own.solved[at(own, i + 1)];
    Real *solved = &own.solved[here], *change = &own.change[here];
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int m = 0; m < count; ++m) {
      solved[m] = (solved[m] - upper[m] * after[m]) * inverse_pivot[m];
      change[m] += PartOf<Real>(over_relaxation) * (solved[m] - change[m]);
    }
  }
}

template <class Real>
void FlowBetweenRows<Real>::correct(const Field<Real>& residual, Field<Real>& change) {
  halo_.exchange(change);
  for (Rows& own : rows_) {
    for (int i = 0; i < nx_; ++i) {
      const Real* z = change.row(i) + own.first;
      const std::size_t here = at(own, i);
      for (int m = 0; m < own.count; ++m) {
        const int j = 2 * m;
        own.right_side[here + m] = -(own.south[here + m] * z[j - 1] + own.north[here + m] * z[j + 1]);
      }
    }
    std::fill(own.change.begin(), own.change.end(), Real(0));
  }
  for (const LeftOut& node : left_out_) {
    const auto z = [&](int i) { return i >= 0 && i < nx_ ? change.row(i)[node.j] : Real(0); };
    Rows& own = rows_[node.j % 2];
    own.right_side[at(own, node.i) + node.j / 2] += residual.row(node.i)[node.j] - node.west_west * z(node.i - 2) -
                                                    node.west * z(node.i - 1) - node.east * z(node.i + 1);
  }
  for (int round = 0; round < rounds; ++round) {
    relax(rows_[0], rows_[1]);
    relax(rows_[1], rows_[0]);
  }
  for (const Rows& own : rows_) {
    for (int i = 1; i < nx_ - 1; ++i) {
      Real* out = change.row(i) + own.first;
      const std::size_t here = at(own, i);
      for (int m = 0; m < own.count; ++m) out[2 * m] += own.change[here + m];
    }
  }
}

template class FlowBetweenRows<float>;
template class FlowBetweenRows<double>;
template class FlowBetweenRows<std::complex<double>>;

}  // namespace gearfilm

#include "film/projected_change.hpp"

#include <algorithm>
#include <vector>

#include "grid/row_axis.hpp"

namespace gearfilm {
namespace {

/// The smallest range that holds these rows too.
RowRange including(const RowRange& rows, int begin, int end) {
  return rows.count() == 0 ? RowRange{begin, end} : RowRange{std::min(rows.begin, begin), std::max(rows.end, end)};
}

template <class Real>
class ProjectedChange {
public:
  ProjectedChange(const Grid& grid, const FilmStencil<Real>& linear, std::span<const double> pressure,
                  std::span<const float> weights, Field<Real>& added, std::span<double> change)
      : nx_(grid.nx()),
        count_(grid.y_count()),
        mirror_row_(grid.mirror_row()),
        linear_(linear),
        pressure_(pressure),
        weights_(weights),
        added_(added),
        change_(change) {}

  void solve() {
    if (!begin()) return;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (int n = 1; n < nx_ - 1; ++n) relax_line(sweep % 2 == 0 ? n : nx_ - 1 - n);
    }
    for (int i = 1; i < nx_ - 1; ++i) {
      for (int j = near_[i].begin; j < near_[i].end; ++j) {
        const std::size_t n = node(i, j);
        const Real added = added_.row(i)[j];
        change_[n] = added == most(n) ? pressure_[n] : change_[n] + added;
      }
    }
  }

private:
  static constexpr int sweeps = 4;
  static constexpr int around = 4;  ///< nodes along X and rows from one that falls dry whose changes are adapted

  std::size_t node(int i, int j) const { return static_cast<std::size_t>(i) * count_ + j; }

  /// What makes the new pressure zero.
  Real most(std::size_t n) const { return static_cast<Real>(pressure_[n] - change_[n]); }

  /// Finds the nodes that would go below zero; false where there are none.
  bool begin() {
    for (int i = 1; i < nx_ - 1; ++i) {
      for (int j = 0; j < count_; ++j) {
        const std::size_t n = node(i, j);
        if (change_[n] <= pressure_[n] || !conducts_freely(weights_[n])) continue;
        if (near_.empty()) {
          near_.resize(nx_);
          added_.fill(Real(0));
        }
        added_.row(i)[j] = most(n);
        for (int line = std::max(1, i - around); line <= std::min(nx_ - 2, i + around); ++line) {
          near_[line] = including(near_[line], std::max(0, j - around), std::min(count_, j + around + 1));
        }
      }
    }
    for (int i = 0; i < static_cast<int>(near_.size()); ++i) mirror(i);
    return !near_.empty();
  }

  void relax_line(int i) {
    const Real *ww = added_.row(std::max(i - 2, 0)), *w = added_.row(i - 1), *e = added_.row(i + 1);
    Real* own = added_.row(i);
    const auto of = [this, i](Neighbour neighbour) { return linear_.by_pressure[neighbour].row(i); };
    for (int j = near_[i].begin; j < near_[i].end; ++j) {
      const std::size_t n = node(i, j);
      const Real slope = of(centre)[j];
      if (!conducts_freely(weights_[n]) || slope <= Real(0)) continue;
      const Real others = of(west_west)[j] * ww[j] + of(west)[j] * w[j] + of(east)[j] * e[j] +
                          of(south)[j] * own[j - 1] + of(north)[j] * own[j + 1];
      own[j] = std::min(-others / slope, most(n));
    }
    mirror(i);
  }

  void mirror(int i) {
    if (mirror_row_ >= 0) added_.row(i)[mirror_row_ - 1] = added_.row(i)[mirror_row_ + 1];
  }

  int nx_, count_, mirror_row_;
  const FilmStencil<Real>& linear_;
  std::span<const double> pressure_;
  std::span<const float> weights_;
  Field<Real>& added_;
  std::span<double> change_;
  std::vector<RowRange> near_;  ///< by line, around nodes that would go below zero; empty where there are none
};

}  // namespace

template <class Real>
void project_change(const Grid& grid, const FilmStencil<Real>& linear, std::span<const double> pressure,
                    std::span<const float> weights, Field<Real>& added, std::span<double> change) {
  ProjectedChange<Real>(grid, linear, pressure, weights, added, change).solve();
}

template void project_change(const Grid&, const FilmStencil<float>&, std::span<const double>, std::span<const float>,
                             Field<float>&, std::span<double>);
template void project_change(const Grid&, const FilmStencil<double>&, std::span<const double>, std::span<const float>,
                             Field<double>&, std::span<double>);

}  // namespace gearfilm

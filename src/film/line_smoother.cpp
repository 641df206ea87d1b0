#include "film/line_smoother.hpp"

#include <cstdlib>
#include <numbers>
#include <utility>

#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

constexpr double distributive_limit = 1.5;  // on xi_R/h_x^2, without oscillation
constexpr double damping = 0.75;            // of nodes that are not cavitated
constexpr double asperity_limit = 1.0;      // on |P_a'| 2 pi C_h
constexpr double oscillation_share = 0.5;   // of |s| in the limit above: a long wave has k of about 2
constexpr double distant_share = 0.5;       // of a long wave's deformation, which the band leaves out

constexpr int lines_between(int i, int k) { return i < k ? k - i : i - k; }

}  // namespace

template <class Real>
LineSmoother<Real>::LineSmoother(const Grid& grid, const Halo& halo, const Deformation<Part>& deformation)
    : Smoother<Real>(grid),
      halo_(halo),
      nx_(grid.nx()),
      rows_(grid.y_count()),
      inverse_h_x2_(1.0 / (grid.h_x() * grid.h_x())),
      long_wave_deformation_(2.0 * std::numbers::pi * deformation.elastic_coefficient()),
      band_(static_cast<std::size_t>(nx_) * band_width * rows_),
      distributive_(grid),
      spread_(grid) {
  const double inverse_h_y2 = 1.0 / (grid.h_y() * grid.h_y());
  const double w_x = 0.5 * inverse_h_x2_ / (inverse_h_x2_ + inverse_h_y2);
  const double w_y = 0.5 * inverse_h_y2 / (inverse_h_x2_ + inverse_h_y2);
  weight_x_ = static_cast<Part>(w_x);
  weight_y_ = static_cast<Part>(w_y);
  const auto kernel = [&](int i, int j) { return deformation.coefficient(std::abs(i), std::abs(j)); };
  const auto spread_out = [&](int i, int j) {
    return -w_x * (kernel(i - 1, j) + kernel(i + 1, j)) - w_y * (kernel(i, j - 1) + kernel(i, j + 1));
  };
  for (int i = 0; i <= kept; ++i) {
    plain_.same_line[i] = static_cast<Part>(kernel(i, 0));
    plain_.next_line[i] = static_cast<Part>(kernel(i, 1));
    correction_.same_line[i] = static_cast<Part>(spread_out(i, 0));
    correction_.next_line[i] = static_cast<Part>(spread_out(i, 1));
  }
}

template <class Real>
void LineSmoother<Real>::choose_unknowns(const FilmState& state, double oscillation) {
  const double largest = distributive_limit * (1.0 + oscillation_share * oscillation) / inverse_h_x2_;
  this->find_coupled(state, long_wave_deformation_);
  for (int i = 0; i < nx_; ++i) {
    const double* __restrict full_here = state.full_film.row(i);  // 0 or 1
    const StateLine line(state, i);
    Part* __restrict distributive = distributive_.row(i);
    for (int j = 0; j < rows_; ++j) {
      distributive[j] = static_cast<Part>(line.conductance(j) < largest ? full_here[j] : 0.0);
    }
    if (!state.rough) continue;
    const double* __restrict slope = state.rough->asperity_slope.row(i);
    const Part* __restrict coupled = coupled_.row(i);
    for (int j = 0; j < rows_; ++j) {
      if (-slope[j] * long_wave_deformation_ > asperity_limit) distributive[j] = coupled[j];
    }
  }
}

// Entry (i, i + offset) of every line: the change of row i per unit of the unknown at i + offset.
template <class Real>
template <int offset>
void LineSmoother<Real>::assemble_diagonal(const FilmStencil<Real>& linear, int i) {
  const int column = i + offset;
  Real* __restrict entry = band(i, offset);
  if (column < 1 || column > nx_ - 2) {
    std::fill_n(entry, rows_, Real(0));
    return;
  }
  const Part* __restrict distributive = distributive_.row(column);
  std::array<const Real*, neighbour_count> v{}, u{};
  for (int n = 0; n < neighbour_count; ++n) {
    v[n] = linear.by_pressure[n].row(i);
    u[n] = linear.by_thickness[n].row(i);
  }
  constexpr std::array distance = {lines_between(-2, offset), lines_between(-1, offset), lines_between(0, offset),
                                   lines_between(1, offset)};
  constexpr int own = lines_between(0, offset);
  const auto [plain_line, plain_next] = plain_;
  const auto [spread_line, spread_next] = correction_;
  // The band is not part of the stencil.
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < rows_; ++j) {
    const Real next_line = u[south][j] + u[north][j];
    Real plain = next_line * plain_next[own];
    Real spread = next_line * spread_next[own];
    for (int n = west_west; n <= east; ++n) {
      plain += u[n][j] * plain_line[distance[n]];
      spread += u[n][j] * spread_line[distance[n]];
      if (distance[n] == 0) plain += v[n][j];
      if (distance[n] == 1) spread -= weight_x_ * v[n][j];
    }
    if constexpr (offset == 0) spread -= weight_y_ * (v[south][j] + v[north][j]);
    entry[j] = plain + distributive[j] * spread;
  }
}

template <class Real>
void LineSmoother<Real>::add_distant_deformation(const FilmState& state, int i) {
  const double weight = distant_share * long_wave_deformation_;
  const double* __restrict density = state.density.row(i);
  const double* __restrict entrained = state.entrained.row(i);
  const double* __restrict full_film = state.full_film.row(i);
  const Part* __restrict distributive = distributive_.row(i);
  Real* __restrict entry = band(i, 0);
  for (int j = 0; j < rows_; ++j) {
    entry[j] +=
        static_cast<Part>(weight * std::abs(entrained[j]) * density[j] * full_film[j]) * (Part(1) - distributive[j]);
  }
}

template <class Real>
template <int... index>
void LineSmoother<Real>::assemble_line(const FilmStencil<Real>& linear, int i, std::integer_sequence<int, index...>) {
  (assemble_diagonal<index - half_width>(linear, i), ...);
}

template <class Real>
void LineSmoother<Real>::factor(const FilmStencil<Real>& linear, const FilmState& state, ShiftOf<Real> shift,
                                SmootherFactors /*factors*/) {
  const ScopedEvent event(Kernel::smoother_factor);
  choose_unknowns(state, std::is_floating_point_v<Real> ? 0.0 : std::abs(shift));
  for (int i = 1; i < nx_ - 1; ++i) {
    assemble_line(linear, i, std::make_integer_sequence<int, band_width>{});
    add_distant_deformation(state, i);
  }
  factor_bands();
}

// LU without pivoting, all lines side by side; the diagonal is stored inverted. Each loop takes all it can at once:
// few values a line are a process's own where there are many processes.
template <class Real>
void LineSmoother<Real>::factor_bands() {
  static_assert(half_width == 3);
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* __restrict pivot = band(i, 0);
    const Real* __restrict upper_1 = band(i, 1);
    const Real* __restrict upper_2 = band(i, 2);
    const Real* __restrict upper_3 = band(i, 3);
    for (int j = 0; j < rows_; ++j) pivot[j] = Real(1) / pivot[j];
    for (int k = 1; k <= half_width && i + k < nx_ - 1; ++k) {
      Real* __restrict lower = band(i + k, -k);
      Real* __restrict target_1 = band(i + k, 1 - k);
      Real* __restrict target_2 = band(i + k, 2 - k);
      Real* __restrict target_3 = band(i + k, 3 - k);
      // Different diagonals are different memory.
      GEARFILM_INDEPENDENT_ITERATIONS
      for (int j = 0; j < rows_; ++j) {
        const Real factor = lower[j] * pivot[j];
        lower[j] = factor;
        target_1[j] -= factor * upper_1[j];
        target_2[j] -= factor * upper_2[j];
        target_3[j] -= factor * upper_3[j];
      }
    }
  }
}

// The bands are zero where they reach beyond the inner nodes: any line may stand in there.
template <class Real>
void LineSmoother<Real>::solve_bands(Field<Real>& values) {
  static_assert(half_width == 3);
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* __restrict value = values.row(i);
    const Real* before_1 = values.row(i - 1);
    const Real* before_2 = values.row(std::max(i - 2, 0));
    const Real* before_3 = values.row(std::max(i - 3, 0));
    const Real* lower_1 = band(i, -1);
    const Real* lower_2 = band(i, -2);
    const Real* lower_3 = band(i, -3);
    for (int j = 0; j < rows_; ++j) {
      value[j] -= lower_1[j] * before_1[j] + lower_2[j] * before_2[j] + lower_3[j] * before_3[j];
    }
  }
  for (int i = nx_ - 2; i >= 1; --i) {
    Real* __restrict value = values.row(i);
    const Real* after_1 = values.row(i + 1);
    const Real* after_2 = values.row(std::min(i + 2, nx_ - 1));
    const Real* after_3 = values.row(std::min(i + 3, nx_ - 1));
    const Real* inverse_pivot = band(i, 0);
    const Real* upper_1 = band(i, 1);
    const Real* upper_2 = band(i, 2);
    const Real* upper_3 = band(i, 3);
    for (int j = 0; j < rows_; ++j) {
      value[j] =
          (value[j] - upper_1[j] * after_1[j] - upper_2[j] * after_2[j] - upper_3[j] * after_3[j]) * inverse_pivot[j];
    }
  }
}

template <class Real>
void LineSmoother<Real>::relax(Field<Real>& residual, Field<Real>& change) {
  const ScopedEvent event(Kernel::smoother_sweep);
  solve_bands(residual);
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* __restrict value = residual.row(i);
    Real* __restrict spread = spread_.row(i);
    const Part* __restrict coupled = coupled_.row(i);
    const Part* __restrict distributive = distributive_.row(i);
    for (int j = 0; j < rows_; ++j) {
      value[j] *= Part(1) - Part(1.0 - damping) * coupled[j];
      spread[j] = value[j] * distributive[j];
    }
  }
  halo_.exchange(spread_);
  for (int i = 1; i < nx_ - 1; ++i) {
    const Real* __restrict here = spread_.row(i);
    const Real* __restrict before = spread_.row(i - 1);
    const Real* __restrict after = spread_.row(i + 1);
    const Part* __restrict coupled = coupled_.row(i);
    const Real* __restrict value = residual.row(i);
    Real* __restrict out = change.row(i);
    for (int j = 0; j < rows_; ++j) {
      const Real neighbours = weight_x_ * (before[j] + after[j]) + weight_y_ * (here[j - 1] + here[j + 1]);
      out[j] += value[j] - coupled[j] * neighbours;
    }
  }
}

template class LineSmoother<float>;
template class LineSmoother<double>;
template class LineSmoother<std::complex<double>>;

}  // namespace gearfilm

#include "film/row_smoother.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// What factors cost, in relaxations with their products, by the number of lines: nx^3 operations against nx^2.
constexpr double relaxations_for_factors = 0.1;

}  // namespace

template <class Real>
RowSmoother<Real>::RowSmoother(const Grid& grid, const Halo& halo, const Deformation<Part>& deformation)
    : Smoother<Real>(grid),
      comm_(grid.comm()),
      nx_(grid.nx()),
      single_(grid.row_axis().single()),
      rows_(grid.y_count()),
      long_wave_deformation_(2.0 * std::numbers::pi * deformation.elastic_coefficient()),
      factored_(grid),
      solved_(grid),
      inverse_scale_(grid),
      deformation_between_(grid, deformation),
      flow_between_(grid, halo),
      relaxed_(grid),
      line_(RowFactors<Real>::stride(nx_)),
      lines_(rows_.size() * line_) {
  const RowAxis& axis = grid.row_axis();
  const std::array<int, places> towards = {-1, 0, 1};
  for (int at = 0; at < places; ++at) {
    std::vector<Part>& of_rows = influence_[at];
    for (int row = grid.y_begin(); row < grid.y_begin() + grid.y_count(); ++row) {
      // Before a row of symmetry lies the image of the next one.
      const int target = axis.mirrored() ? std::abs(row + towards[at]) : row + towards[at];
      const bool inside = target >= 0 && target < axis.count();
      const double images = row == axis.mirror_row() ? 2.0 : 1.0;  // of a row of symmetry it is the row itself
      std::vector<Part> half;
      for (int i = 0; i <= nx_ && inside; ++i) {
        half.push_back(static_cast<Part>(deformation.coefficient(i, target, row) / images));
      }
      for (int i = -nx_; i <= nx_; ++i) of_rows.push_back(inside ? half[std::abs(i)] : Part(0));
    }
  }
}

// Column by column. Oil in the inlet conducts so well that what its pressure changes farther away, by deformation, is
// left out of the first columns, as long as it is small: their factors are short then. A single row is solved exactly.
template <class Real>
void RowSmoother<Real>::assemble(const FilmStencil<Real>& linear, int j, std::vector<Real>& matrix) {
  constexpr int nearby = 8;            // lines; columns of which one is tried
  constexpr double negligible = 0.01;  // of the entry in the diagonal
  const std::vector<int>& coupled = rows_[j].coupled;
  std::array<std::vector<Real>, neighbour_count> v, u;
  for (int n = 0; n < neighbour_count; ++n) {
    v[n].resize(nx_);
    u[n].resize(nx_);
    for (int i = 0; i < nx_; ++i) {
      v[n][i] = linear.by_pressure[n].row(i)[j];
      u[n][i] = linear.by_thickness[n].row(i)[j];
    }
  }
  const Real *u_ww = u[west_west].data(), *u_w = u[west].data(), *u_c = u[centre].data(), *u_e = u[east].data(),
             *u_s = u[south].data(), *u_n = u[north].data();
  std::vector<Real> column(nx_);
  const auto fill = [&](int k, int first, int last) {
    const Part *own = influence(own_row, j) - k, *before = influence(row_before, j) - k,
               *after = influence(row_after, j) - k;
    for (int i = first; i <= last; ++i) {
      column[i] = u_ww[i] * own[i - 2] + u_w[i] * own[i - 1] + u_c[i] * own[i] + u_e[i] * own[i + 1] +
                  u_s[i] * before[i] + u_n[i] * after[i];
    }
    column[k] += v[centre][k];
    if (k > 0) column[k - 1] += v[east][k - 1];
    if (k + 1 < nx_) column[k + 1] += v[west][k + 1];
    if (k + 2 < nx_) column[k + 2] += v[west_west][k + 2];
  };
  const auto changes_farther_away = [&](int k) {
    fill(k, coupled.front(), coupled.back());
    return std::ranges::any_of(coupled, [&](int i) {
      return std::abs(i - k) > nearby && std::abs(column[i]) > negligible * std::abs(column[k]);
    });
  };
  const int size = static_cast<int>(coupled.size());
  int local = 0;  // first columns
  while (!single_ && local + nearby <= size && !changes_farther_away(coupled[local + nearby - 1])) local += nearby;
  matrix.assign(RowFactors<Real>::entries(size), Real(0));
  for (int n = 0; n < size; ++n) {
    const int k = coupled[n];
    const int first = n < local ? std::max(coupled.front(), k - nearby) : coupled.front();
    const int last = n < local ? std::min(coupled.back(), k + nearby) : coupled.back();
    fill(k, first, last);
    Real* out = matrix.data() + n * RowFactors<Real>::stride(size);
    for (auto at = std::ranges::lower_bound(coupled, first); at != coupled.end() && *at <= last; ++at) {
      out[at - coupled.begin()] = column[*at];
    }
  }
}

template <class Real>
bool RowSmoother<Real>::serve(ShiftOf<Real> shift) const {
  constexpr double same = 1e-6;          // lengths of steps differ by round-off
  constexpr double most_changed = 0.01;  // of the coupled nodes
  if (use_.linearisations == 0 || std::abs(shift - use_.shift) > same * std::abs(shift)) return false;
  std::array<double, 2> nodes{};
  auto& [changed, all] = nodes;
  for (int i = 0; i < nx_; ++i) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      all += this->coupled_.row(i)[j];
      changed += std::abs(this->coupled_.row(i)[j] - factored_.row(i)[j]);
    }
  }
  // Factors are made together: all processes decide alike.
  MPI_Allreduce(MPI_IN_PLACE, nodes.data(), 2, MPI_DOUBLE, MPI_SUM, comm_);
  if (changed > most_changed * all) return false;
  return use_.last * use_.linearisations <= use_.cost + use_.relaxations;
}

template <class Real>
void RowSmoother<Real>::make_factors(const FilmStencil<Real>& linear) {
  for (Row& row : rows_) row.coupled.clear();
  factored_ = this->coupled_;
  for (int i = 0; i < nx_; ++i) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      if (this->coupled_.row(i)[j] != 0.0) rows_[j].coupled.push_back(i);
    }
  }
  std::vector<Real> matrix;
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    if (rows_[j].coupled.empty()) continue;
    assemble(linear, static_cast<int>(j), matrix);
    rows_[j].factors.compute(matrix, static_cast<int>(rows_[j].coupled.size()));
  }
}

template <class Real>
void RowSmoother<Real>::factor(const FilmStencil<Real>& linear, const FilmState& state, ShiftOf<Real> shift,
                               SmootherFactors factors) {
  const ScopedEvent event(Kernel::smoother_factor);
  this->find_coupled(state, long_wave_deformation_);
  const bool kept = factors == SmootherFactors::of_earlier_states_too && serve(shift);
  if (!kept) {
    make_factors(linear);
    use_ = {shift, relaxations_for_factors * nx_};
  }
  ++use_.linearisations;
  use_.last = 0;
  Field<Part> left_out = this->coupled_;
  for (int i = 0; i < nx_; ++i) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      solved_.row(i)[j] = factored_.row(i)[j] * this->coupled_.row(i)[j];
      left_out.row(i)[j] -= solved_.row(i)[j];
      const Part alone = Part(1) - (single_ ? solved_ : this->coupled_).row(i)[j];
      inverse_scale_.row(i)[j] = Real(alone) / linear.by_pressure[centre].row(i)[j];
    }
  }
  if (single_) return;
  if (!kept) {
    displacement_column(linear, relaxed_);
    Field<Real> responses = relaxed_;
    solve_rows(relaxed_, responses);
    deformation_between_.factor(std::move(responses));
  }
  flow_between_.factor(linear, left_out);
}

template <class Real>
void RowSmoother<Real>::relax(Field<Real>& residual, Field<Real>& change) {
  const ScopedEvent event(Kernel::smoother_sweep);
  ++use_.relaxations;
  ++use_.last;
  solve_rows(residual, relaxed_);
  add_corrected(residual, change);
}

// As the rows answered when their factors were made.
template <class Real>
bool RowSmoother<Real>::relax_displacement(const Field<Real>& column, Field<Real>& change) {
  if (single_) return false;
  const ScopedEvent event(Kernel::smoother_sweep);
  relaxed_ = deformation_between_.responses();
  add_corrected(column, change);
  return true;
}

template <class Real>
void RowSmoother<Real>::add_corrected(const Field<Real>& residual, Field<Real>& change) {
  if (!single_) {
    deformation_between_.correct(relaxed_);
    flow_between_.correct(residual, relaxed_);
  }
  for (int i = 1; i < nx_ - 1; ++i) {
    for (std::size_t j = 0; j < rows_.size(); ++j) change.row(i)[j] += relaxed_.row(i)[j];
  }
}

template <class Real>
void RowSmoother<Real>::solve_rows(const Field<Real>& residual, Field<Real>& change) {
  constexpr std::size_t together = 16;  // rows, between fields and lines: neighbours in memory
  for (std::size_t first = 0; first < rows_.size(); first += together) {
    const std::size_t end = std::min(first + together, rows_.size());
    for (int i = 0; i < nx_; ++i) {
      const Part* solved = solved_.row(i);
      for (std::size_t j = first; j < end; ++j) lines_[j * line_ + i] = residual.row(i)[j] * solved[j];
    }
    for (std::size_t j = first; j < end; ++j) solve_row(rows_[j], lines_.data() + j * line_);
    for (int i = 1; i < nx_ - 1; ++i) {
      const Part* solved = solved_.row(i);
      for (std::size_t j = first; j < end; ++j) {
        change.row(i)[j] = inverse_scale_.row(i)[j] * residual.row(i)[j] + lines_[j * line_ + i] * solved[j];
      }
    }
  }
}

template <class Real>
void RowSmoother<Real>::solve_row(const Row& row, Real* line) {
  const std::vector<int>& coupled = row.coupled;
  if (coupled.empty()) return;
  if (coupled.back() - coupled.front() + 1 == static_cast<int>(coupled.size())) {
    return row.factors.solve(line + coupled.front());
  }
  values_.assign(RowFactors<Real>::stride(static_cast<int>(coupled.size())), Real(0));
  for (std::size_t m = 0; m < coupled.size(); ++m) values_[m] = line[coupled[m]];
  row.factors.solve(values_.data());
  for (std::size_t m = 0; m < coupled.size(); ++m) line[coupled[m]] = values_[m];
}

template class RowSmoother<float>;
template class RowSmoother<double>;
template class RowSmoother<std::complex<double>>;

}  // namespace gearfilm

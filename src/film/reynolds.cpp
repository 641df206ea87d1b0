#include "gearfilm/film/reynolds.hpp"

#include <algorithm>
#include <vector>

#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// Wedge d(rho H (U + W))/dX of line i in upwind differences.
void add_wedge(const FilmState& state, double inverse_h_x, int i, double* line) {
  const auto mass = [&](int n, int j) {
    return state.density.row(n)[j] * state.thickness.row(n)[j] * state.entrained.row(n)[j];
  };
  const int rows = state.thickness.y_count();
  if (i == 1) {
    for (int j = 0; j < rows; ++j) line[j] += inverse_h_x * (mass(i, j) - mass(i - 1, j));
  } else {
    for (int j = 0; j < rows; ++j) {
      line[j] += inverse_h_x * (1.5 * mass(i, j) - 2.0 * mass(i - 1, j) + 0.5 * mass(i - 2, j));
    }
  }
}

/// Poiseuille flow out of the cells of line i.
void add_poiseuille(const FilmState& state, const ReynoldsWeights& weights, int i, double* line) {
  const double* p = state.film_pressure().row(i);
  const double* p_west = state.film_pressure().row(i - 1);
  const double* p_east = state.film_pressure().row(i + 1);
  const double* xi = state.conductance.row(i);
  const double* xi_west = state.conductance.row(i - 1);
  const double* xi_east = state.conductance.row(i + 1);
  const double* across = state.across_row(i);
  const double *to_south = weights.south.data(), *to_north = weights.north.data();
  const auto xi_y = [&](int j) { return across[j] * xi[j]; };
  for (int j = 0; j < state.thickness.y_count(); ++j) {
    const double east = 0.5 * (xi[j] + xi_east[j]) * (p_east[j] - p[j]);
    const double west = 0.5 * (xi[j] + xi_west[j]) * (p[j] - p_west[j]);
    const double north = 0.5 * (xi_y(j) + xi_y(j + 1)) * (p[j + 1] - p[j]);
    const double south = 0.5 * (xi_y(j) + xi_y(j - 1)) * (p[j] - p[j - 1]);
    line[j] -= weights.inverse_h_x2 * (east - west) + (to_north[j] * north - to_south[j] * south);
  }
}

/// Where oil is pushed over the front of a full region, it goes as far as what it meets has room for: nodes there, full
/// or not by themselves, are full. By itself the front would come forward by one node an iteration.
void advance_fronts(const Grid& grid, FilmState& state, std::span<double> residual) {
  const RowRange rows = grid.inner_rows();
  const auto sweep = [&](int first, int last, int way) {
    std::vector<double> pushed(grid.y_count(), 0.0);
    for (int i = first; i != last; i += way) {
      const double *pressure = state.film_pressure().row(i), *behind = state.film_pressure().row(i - way);
      double* full_film = state.full_film.row(i);
      const double* line = residual.data() + static_cast<std::ptrdiff_t>(i) * grid.y_count();
      double* over = pushed.data();
      GEARFILM_INDEPENDENT_ITERATIONS
      for (int j = rows.begin; j < rows.end; ++j) {
        const bool empty = pressure[j] <= 0.0;
        const bool front = empty & (line[j] < 0.0) & (behind[j] > 0.0);
        const bool filled = empty & (line[j] >= 0.0) & (line[j] <= over[j]);
        const double left = filled ? over[j] - line[j] : 0.0;
        full_film[j] = filled ? 1.0 : full_film[j];
        over[j] = front ? -line[j] : left;
      }
    }
  };
  sweep(1, grid.nx() - 1, 1);
  sweep(grid.nx() - 2, 0, -1);
}

}  // namespace

ReynoldsWeights::ReynoldsWeights(const Grid& grid, std::span<const double> entrainment, double scheme_shift)
    : inverse_h_x(1.0 / grid.h_x()), inverse_h_x2(inverse_h_x * inverse_h_x), U(entrainment), shift(scheme_shift) {
  for (int j = 0; j < grid.y_count(); ++j) {
    const double before = grid.row_axis().step(grid.y_begin() + j - 1),
                 after = grid.row_axis().step(grid.y_begin() + j);
    const double width = 0.5 * (before + after);
    south.push_back(1.0 / (width * before));
    north.push_back(1.0 / (width * after));
  }
}

void reynolds_residual(const Grid& grid, std::span<const double> entrainment, FilmState& state, const Squeeze& squeeze,
                       std::span<double> residual) {
  const ScopedEvent event(Kernel::residual);
  const ReynoldsWeights weights(grid, entrainment, squeeze.shift);
  const int rows = grid.y_count();
  std::vector<double> line(rows);
  const RowRange inner = grid.inner_rows();
  for (int i = 0; i < grid.nx(); ++i) {
    const bool interior = i > 0 && i < grid.nx() - 1;
    const double* pressure = state.film_pressure().row(i);
    const double* conductance = state.conductance.row(i);
    double* full_film = state.full_film.row(i);
    double* scale = state.row_scale.row(i);
    double* out = residual.data() + static_cast<std::size_t>(i) * rows;
    if (interior) {
      std::fill(line.begin(), line.end(), 0.0);
      if (!squeeze.rate.empty()) {
        std::copy_n(squeeze.rate.begin() + static_cast<std::ptrdiff_t>(i) * rows, rows, line.begin());
      }
      add_wedge(state, weights.inverse_h_x, i, line.data());
      add_poiseuille(state, weights, i, line.data());
    }
    const double inside = interior ? 1.0 : 0.0, *found = line.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < rows; ++j) {
      const double row_scale = weights.row_scale(j, conductance[j]);
      scale[j] = row_scale;
      full_film[j] = found[j] < row_scale * pressure[j] ? inside : 0.0;
      out[j] = found[j];
    }
    std::fill(full_film, full_film + inner.begin, 0.0);
    std::fill(full_film + inner.end, full_film + rows, 0.0);
  }
  advance_fronts(grid, state, residual);
  for (int i = 0; i < grid.nx(); ++i) {
    const double *pressure = state.film_pressure().row(i), *full_film = state.full_film.row(i),
                 *scale = state.row_scale.row(i);
    double* out = residual.data() + static_cast<std::size_t>(i) * rows;
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < rows; ++j) {
      const double given = out[j], dry = scale[j] * pressure[j];
      out[j] = full_film[j] != 0.0 ? given : dry;
    }
  }
}

}  // namespace gearfilm

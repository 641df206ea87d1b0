#include "gearfilm/ehl/linear_film.hpp"

#include "gearfilm/ehl/events.hpp"

namespace gearfilm {
namespace {

/// One node's stencil, before the wet mask.
struct NodeStencil {
  std::array<double, neighbour_count> v{};
  std::array<double, neighbour_count> u{};
};

/// Derivative of -(flux_out) through one face between this node and a neighbour:
/// flux = 0.5 (xi + xi_n)(P_n - P), all divided by h^2 through `weight`.
struct Face {
  double conductance;  ///< mean xi_R / h^2
  double half_slope;   ///< 0.5 (P_n - P)/h^2
};

Face face(double xi, double xi_neighbour, double p, double p_neighbour, double weight) {
  return {0.5 * weight * (xi + xi_neighbour), 0.5 * weight * (p_neighbour - p)};
}

NodeStencil poiseuille_stencil(const FilmState& s, const ReynoldsWeights& weights, int i, int j) {
  NodeStencil stencil;
  const double xi = s.conductance.row(i)[j], p = s.pressure.row(i)[j];
  const double xi_p = s.conductance_by_pressure.row(i)[j], xi_h = s.conductance_by_film.row(i)[j];
  const auto add = [&](Neighbour side, int n, int m, double weight) {
    const Face f = face(xi, s.conductance.row(n)[m], p, s.pressure.row(n)[m], weight);
    stencil.v[side] -= f.conductance + f.half_slope * s.conductance_by_pressure.row(n)[m];
    stencil.u[side] -= f.half_slope * s.conductance_by_film.row(n)[m];
    stencil.v[centre] += f.conductance - f.half_slope * xi_p;
    stencil.u[centre] -= f.half_slope * xi_h;
  };
  add(west, i - 1, j, weights.inverse_h_x2);
  add(east, i + 1, j, weights.inverse_h_x2);
  add(south, i, j - 1, weights.inverse_h_y2);
  add(north, i, j + 1, weights.inverse_h_y2);
  return stencil;
}

void add_mass(const FilmState& s, double weight, int i, int j, Neighbour side, NodeStencil& stencil) {
  stencil.v[side] += weight * s.density_by_pressure.row(i)[j] * s.film.row(i)[j];
  stencil.u[side] += weight * s.density.row(i)[j];
}

}  // namespace

template <class Real>
void linearise(const Grid& grid, double entrainment, double storage_shift, const FilmState& state,
               LinearFilm<Real>& linear) {
  const ScopedEvent event(Kernel::linearise);
  const ReynoldsWeights weights(grid, entrainment);
  for (int i = 0; i < grid.nx(); ++i) {
    const bool interior = i > 0 && i < grid.nx() - 1;
    const bool first = i == 1;
    for (int j = 0; j < grid.y_count(); ++j) {
      NodeStencil stencil;
      if (interior && state.wet.row(i)[j] != 0.0) {
        stencil = poiseuille_stencil(state, weights, i, j);
        add_mass(state, weights.wedge * (first ? 1.0 : 1.5) + storage_shift, i, j, centre, stencil);
        add_mass(state, weights.wedge * (first ? -1.0 : -2.0), i - 1, j, west, stencil);
        if (!first) add_mass(state, weights.wedge * 0.5, i - 2, j, west_west, stencil);
      } else {
        stencil.v[centre] = state.row_scale.row(i)[j];
      }
      for (int n = 0; n < neighbour_count; ++n) {
        linear.by_pressure[n].row(i)[j] = static_cast<Real>(stencil.v[n]);
        linear.by_film[n].row(i)[j] = static_cast<Real>(stencil.u[n]);
      }
    }
  }
}

namespace {

/// rows_i (+)= sum over the neighbours of coefficient * value, for one line and one kind of change.
template <class Real>
void add_line(const std::array<Field<Real>, neighbour_count>& coefficients, const Field<Real>& value, int i,
              Real* __restrict rows) {
  const int last = value.nx() - 1;
  // Lines beyond the grid have zero coefficients: any valid line may stand in for them.
  const Real* __restrict ww = value.row(std::max(i - 2, 0));
  const Real* __restrict w = value.row(std::max(i - 1, 0));
  const Real* __restrict c = value.row(i);
  const Real* __restrict e = value.row(std::min(i + 1, last));
  const Real* __restrict a_ww = coefficients[west_west].row(i);
  const Real* __restrict a_w = coefficients[west].row(i);
  const Real* __restrict a_c = coefficients[centre].row(i);
  const Real* __restrict a_e = coefficients[east].row(i);
  const Real* __restrict a_s = coefficients[south].row(i);
  const Real* __restrict a_n = coefficients[north].row(i);
  const int count = value.y_count();
  for (int j = 0; j < count; ++j) {
    rows[j] += a_ww[j] * ww[j] + a_w[j] * w[j] + a_c[j] * c[j] + a_e[j] * e[j] + a_s[j] * c[j - 1] + a_n[j] * c[j + 1];
  }
}

}  // namespace

template <class Real>
void apply_stencil(const LinearFilm<Real>& linear, const Field<Real>& v, const Field<Real>& u, Field<Real>& rows) {
  for (int i = 0; i < v.nx(); ++i) {
    std::fill_n(rows.row(i), v.y_count(), Real(0));
    add_line(linear.by_pressure, v, i, rows.row(i));
    add_line(linear.by_film, u, i, rows.row(i));
  }
}

void film_shift_column(const LinearFilm<double>& linear, double* column) {
  const int rows = linear.by_film[0].y_count();
  for (int i = 0; i < linear.by_film[0].nx(); ++i) {
    for (int j = 0; j < rows; ++j) {
      double sum = 0.0;
      for (const Field<double>& coefficient : linear.by_film) sum += coefficient.row(i)[j];
      column[static_cast<std::size_t>(i) * rows + j] = sum;
    }
  }
}

template void linearise(const Grid&, double, double, const FilmState&, LinearFilm<float>&);
template void linearise(const Grid&, double, double, const FilmState&, LinearFilm<double>&);
template void apply_stencil(const LinearFilm<float>&, const Field<float>&, const Field<float>&, Field<float>&);
template void apply_stencil(const LinearFilm<double>&, const Field<double>&, const Field<double>&, Field<double>&);

}  // namespace gearfilm

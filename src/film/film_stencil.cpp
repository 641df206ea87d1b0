#include "film/film_stencil.hpp"

#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// Weights of rho H of the nodes i-2, i-1, i in the row of line i: of the wedge, to be multiplied by U + W, and of the
/// squeeze term.
template <class Shift>
struct MassWeights {
  double west_west, west, centre;
  Shift squeeze;
};

/// The fields of a state on one line.
struct StateLine {
  StateLine(const FilmState& state, int i)
      : p(state.film_pressure().row(i)),
        h(state.thickness.row(i)),
        rho(state.density.row(i)),
        rho_p(state.density_by_pressure.row(i)),
        xi(state.conductance.row(i)),
        xi_p(state.conductance_by_pressure.row(i)),
        xi_h(state.conductance_by_thickness.row(i)),
        entrained(state.entrained.row(i)),
        across(state.across_row(i)) {}

  const double *p, *h, *rho, *rho_p, *xi, *xi_p, *xi_h, *entrained, *across;
};

/// Derivatives of the flow through the face between this node (0) and a neighbour (n), out of this node's cell:
/// -0.5 (A_0 xi_0 + A_n xi_n)(P_n - P_0)/h^2, A = 1 along x. Each neighbour's line may be this one, at j - 1 or j + 1.
struct Face {
  Face(const StateLine& here, const StateLine& there, int j, double weight)
      : conductance(0.5 * weight * (here.xi[j] + there.xi[j])), half_slope(0.5 * weight * (there.p[j] - here.p[j])) {}
  Face(const StateLine& line, int j, int m, double weight)
      : conductance(0.5 * weight * (line.across[j] * line.xi[j] + line.across[m] * line.xi[m])),
        half_slope(0.5 * weight * (line.p[m] - line.p[j])),
        factor(line.across[m]) {}

  double by_pressure(const StateLine& there, int m) const { return -conductance - half_slope * factor * there.xi_p[m]; }
  double by_thickness(const StateLine& there, int m) const { return -half_slope * factor * there.xi_h[m]; }

  double conductance;
  double half_slope;
  double factor = 1.0;
};

/// The rows of an inner line; those of nodes that are not full have the scale d on their diagonal only.
template <class Real>
void linearise_line(const FilmState& state, const ReynoldsWeights& weights, const MassWeights<ShiftOf<Real>>& mass,
                    int i, FilmStencil<Real>& linear) {
  const StateLine ww(state, std::max(i - 2, 0)), w(state, i - 1), c(state, i), e(state, i + 1);
  const double *full_film = state.full_film.row(i), *scale = state.row_scale.row(i);
  std::array<Real*, neighbour_count> v{}, u{};
  for (int n = 0; n < neighbour_count; ++n) {
    v[n] = linear.by_pressure[n].row(i);
    u[n] = linear.by_thickness[n].row(i);
  }
  const int count = state.thickness.y_count();
  const double x_weight = weights.inverse_h_x2;
  const double *south_weight = weights.south.data(), *north_weight = weights.north.data();
  // The lines of state and stencil are different memory.
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const Face to_west(c, w, j, x_weight), to_east(c, e, j, x_weight);
    const Face to_south(c, j, j - 1, south_weight[j]), to_north(c, j, j + 1, north_weight[j]);
    const double own = to_west.conductance + to_east.conductance + to_south.conductance + to_north.conductance;
    const double slopes =
        to_west.half_slope + to_east.half_slope + c.across[j] * (to_south.half_slope + to_north.half_slope);
    const double on = full_film[j];
    const double mass_ww = mass.west_west * ww.entrained[j], mass_w = mass.west * w.entrained[j];
    const ShiftOf<Real> mass_c = mass.centre * c.entrained[j] + mass.squeeze;
    v[west_west][j] = static_cast<Real>(on * mass_ww * ww.rho_p[j] * ww.h[j]);
    u[west_west][j] = static_cast<Real>(on * mass_ww * ww.rho[j]);
    v[west][j] = static_cast<Real>(on * (to_west.by_pressure(w, j) + mass_w * w.rho_p[j] * w.h[j]));
    u[west][j] = static_cast<Real>(on * (to_west.by_thickness(w, j) + mass_w * w.rho[j]));
    v[centre][j] =
        static_cast<Real>(on * (own - slopes * c.xi_p[j] + mass_c * c.rho_p[j] * c.h[j]) + (1.0 - on) * scale[j]);
    u[centre][j] = static_cast<Real>(on * (mass_c * c.rho[j] - slopes * c.xi_h[j]));
    v[east][j] = static_cast<Real>(on * to_east.by_pressure(e, j));
    u[east][j] = static_cast<Real>(on * to_east.by_thickness(e, j));
    v[south][j] = static_cast<Real>(on * to_south.by_pressure(c, j - 1));
    u[south][j] = static_cast<Real>(on * to_south.by_thickness(c, j - 1));
    v[north][j] = static_cast<Real>(on * to_north.by_pressure(c, j + 1));
    u[north][j] = static_cast<Real>(on * to_north.by_thickness(c, j + 1));
  }
}

/// The rows of an edge of the grid: d v.
template <class Real>
void linearise_edge(const FilmState& state, int i, FilmStencil<Real>& linear) {
  const int count = state.thickness.y_count();
  for (int n = 0; n < neighbour_count; ++n) {
    std::fill_n(linear.by_pressure[n].row(i), count, Real(0));
    std::fill_n(linear.by_thickness[n].row(i), count, Real(0));
  }
  for (int j = 0; j < count; ++j) linear.by_pressure[centre].row(i)[j] = static_cast<Real>(state.row_scale.row(i)[j]);
}

}  // namespace

template <class Real>
void linearise(const Grid& grid, ShiftOf<Real> shift, const FilmState& state, FilmStencil<Real>& linear) {
  const ScopedEvent event(Kernel::linearise);
  const ReynoldsWeights weights(grid, {});
  const double wedge = weights.inverse_h_x;
  linearise_edge(state, 0, linear);
  for (int i = 1; i < grid.nx() - 1; ++i) {
    const MassWeights<ShiftOf<Real>> mass =
        i == 1 ? MassWeights<ShiftOf<Real>>{0.0, -wedge, wedge, shift}
               : MassWeights<ShiftOf<Real>>{0.5 * wedge, -2.0 * wedge, 1.5 * wedge, shift};
    linearise_line(state, weights, mass, i, linear);
  }
  linearise_edge(state, grid.nx() - 1, linear);
}

namespace {

/// The values of one line and its neighbours. Lines beyond the grid have zero coefficients: any valid line may stand in
/// for them.
template <class Real>
struct NeighbourLines {
  NeighbourLines(const Field<Real>& value, int i)
      : ww(value.row(std::max(i - 2, 0))),
        w(value.row(std::max(i - 1, 0))),
        c(value.row(i)),
        e(value.row(std::min(i + 1, value.nx() - 1))) {}

  const Real *ww, *w, *c, *e;
};

template <class Real>
struct CoefficientLines {
  CoefficientLines(const std::array<Field<Real>, neighbour_count>& fields, int i)
      : ww(fields[west_west].row(i)),
        w(fields[west].row(i)),
        c(fields[centre].row(i)),
        e(fields[east].row(i)),
        s(fields[south].row(i)),
        n(fields[north].row(i)) {}

  Real applied_to(const NeighbourLines<Real>& value, int j) const {
    return ww[j] * value.ww[j] + w[j] * value.w[j] + c[j] * value.c[j] + e[j] * value.e[j] + s[j] * value.c[j - 1] +
           n[j] * value.c[j + 1];
  }

  const Real *ww, *w, *c, *e, *s, *n;
};

}  // namespace

template <class Real>
void apply_stencil(const FilmStencil<Real>& linear, const Field<Real>& v, const Field<Real>& u, Field<Real>& rows) {
  const int count = v.y_count();
  for (int i = 0; i < v.nx(); ++i) {
    const NeighbourLines<Real> v_lines(v, i), u_lines(u, i);
    const CoefficientLines<Real> by_pressure(linear.by_pressure, i), by_thickness(linear.by_thickness, i);
    Real* out = rows.row(i);
    // The rows are neither values nor coefficients.
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < count; ++j) out[j] = by_pressure.applied_to(v_lines, j) + by_thickness.applied_to(u_lines, j);
  }
}

template <class Real>
void displacement_column(const FilmStencil<Real>& linear, std::span<double> column) {
  const int rows = linear.by_thickness[0].y_count();
  for (int i = 0; i < linear.by_thickness[0].nx(); ++i) {
    double* line = column.data() + static_cast<std::size_t>(i) * rows;
    std::fill_n(line, rows, 0.0);
    for (const Field<Real>& coefficient : linear.by_thickness) {
      const Real* values = coefficient.row(i);
      for (int j = 0; j < rows; ++j) line[j] += values[j];
    }
  }
}

template void linearise(const Grid&, double, const FilmState&, FilmStencil<float>&);
template void linearise(const Grid&, double, const FilmState&, FilmStencil<double>&);
template void linearise(const Grid&, std::complex<double>, const FilmState&, FilmStencil<std::complex<double>>&);
template void displacement_column(const FilmStencil<float>&, std::span<double>);
template void displacement_column(const FilmStencil<double>&, std::span<double>);
template void apply_stencil(const FilmStencil<float>&, const Field<float>&, const Field<float>&, Field<float>&);
template void apply_stencil(const FilmStencil<double>&, const Field<double>&, const Field<double>&, Field<double>&);
template void apply_stencil(const FilmStencil<std::complex<double>>&, const Field<std::complex<double>>&,
                            const Field<std::complex<double>>&, Field<std::complex<double>>&);

}  // namespace gearfilm

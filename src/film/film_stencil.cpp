#include "film/film_stencil.hpp"

#include "film/face_flow.hpp"
#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// Derivatives of the flows through a line of faces, by P and H of the nodes W, 0 and 1 of each.
struct FaceDerivatives {
  explicit FaceDerivatives(int faces)
      : p_w(faces), p_0(faces), p_1(faces), h_w(faces), h_0(faces), h_1(faces), carried_only(faces) {}

  template <bool with_rates, class FlowAt>
  [[gnu::always_inline]] void find(int faces, FlowAt flow_at) {
    double *by_p_w = p_w.data(), *by_p_0 = p_0.data(), *by_p_1 = p_1.data();
    double *by_h_w = h_w.data(), *by_h_0 = h_0.data(), *by_h_1 = h_1.data();
    double* carried = carried_only.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < faces; ++j) {
      const FaceFlow flow = flow_at(j);
      by_p_w[j] = flow.by_p_w;
      by_p_0[j] = flow.by_p_0;
      by_p_1[j] = flow.by_p_1;
      by_h_w[j] = flow.by_h_w;
      by_h_0[j] = flow.by_h_0;
      by_h_1[j] = flow.by_h_1;
      if constexpr (with_rates) carried[j] = flow.carried_only;
    }
  }

  std::vector<double> p_w, p_0, p_1, h_w, h_0, h_1;
  std::vector<double> carried_only;  ///< of flows along X
};

/// The rows of inner lines, one after the other; those of nodes that are not full have the scale d on their diagonal
/// only.
template <class Real, FilmDiscretisation discretisation, class Line, bool with_rates>
class LineRows {
public:
  LineRows(const ReynoldsEquation& equation, const FilmState& state, ShiftOf<Real> shift)
      : equation_(equation),
        state_(state),
        shift_(shift),
        count_(equation.grid.y_count()),
        west_(count_),
        east_(count_),
        across_(count_ + 1) {
    find_along_x(0);
  }

  void find(int i, FilmStencil<Real>& linear) {
    std::swap(west_, east_);
    find_along_x(i);
    const Line across(state_, i, FlowDirection::across);
    across_.template find<false>(
        count_ + 1, [&](int j) __attribute__((always_inline)) { return flow_along_y<discretisation>(across, j - 1); });
    write<&FilmStencil<Real>::by_pressure>(
        i, {west_.p_w.data(), west_.p_0.data(), west_.p_1.data()},
        {east_.p_w.data(), east_.p_0.data(), east_.p_1.data()}, across_.p_0.data(), across_.p_1.data(),
        [](const Line& line, int j) { return line.rho_p[j] * line.h[j]; }, state_.row_scale.row(i), linear);
    const std::vector<double> none(count_, 0.0);
    write<&FilmStencil<Real>::by_thickness>(
        i, {west_.h_w.data(), west_.h_0.data(), west_.h_1.data()},
        {east_.h_w.data(), east_.h_0.data(), east_.h_1.data()}, across_.h_0.data(), across_.h_1.data(),
        [](const Line& line, int j) { return line.rho[j] * line.mean_slope(j); }, none.data(), linear);
  }

private:
  struct Face {
    const double *w, *node_0, *node_1;
  };

  void find_along_x(int i) {
    const FlowAlongX<discretisation, Line, with_rates> flow(equation_, state_, i);
    east_.template find<with_rates>(
        count_, [&](int j) __attribute__((always_inline)) { return flow.at(j); });
  }

  /// V or W of line i; mass: the derivative of rho H, other: the diagonal of nodes that are not full.
  template <std::array<Field<Real>, neighbour_count> FilmStencil<Real>::*coefficients, class Mass>
  void write(int i, Face before, Face behind, const double* side_0, const double* side_1, Mass mass,
             const double* other, FilmStencil<Real>& linear) const {
    std::array<Real*, neighbour_count> out{};
    for (int n = 0; n < neighbour_count; ++n) out[n] = (linear.*coefficients)[n].row(i);
    const double *full_film = state_.full_film.row(i), *to_south = equation_.south.data(),
                 *to_north = equation_.north.data();
    const ShiftOf<Real> shift = shift_;
    const Line west_west_line(state_, std::max(i - 2, 0)), west_line(state_, i - 1), line(state_, i),
        east_line(state_, i + 1);
    const double *carried_before = west_.carried_only.data(), *carried_behind = east_.carried_only.data();
    const FaceWeights of_rates = state_.of_rates;
    // The lines of state and stencil are different memory.
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < count_; ++j) {
      const double on = full_film[j];
      const double flows = behind.node_0[j] - before.node_1[j] + to_north[j] * side_0[j + 1] - to_south[j] * side_1[j];
      std::array<ShiftOf<Real>, 4> along{-before.w[j], behind.w[j] - before.node_0[j], flows + shift * mass(line, j),
                                         behind.node_1[j]};
      if constexpr (with_rates) {
        const double in = carried_before[j], by = carried_behind[j];
        along[west_west] -= shift * (of_rates.w * in * mass(west_west_line, j));
        along[west] += shift * ((of_rates.w * by - of_rates.node_0 * in) * mass(west_line, j));
        along[centre] += shift * ((of_rates.node_0 * by - of_rates.node_1 * in) * mass(line, j));
        along[east] += shift * (of_rates.node_1 * by * mass(east_line, j));
      }
      out[west_west][j] = static_cast<Real>(on * along[west_west]);
      out[west][j] = static_cast<Real>(on * along[west]);
      out[centre][j] = static_cast<Real>(on * along[centre] + (1.0 - on) * other[j]);
      out[east][j] = static_cast<Real>(on * along[east]);
      out[south][j] = static_cast<Real>(-on * to_south[j] * side_0[j]);
      out[north][j] = static_cast<Real>(on * to_north[j] * side_1[j + 1]);
    }
  }

  const ReynoldsEquation& equation_;
  const FilmState& state_;
  ShiftOf<Real> shift_;
  int count_;
  FaceDerivatives west_, east_;  ///< along X, of the faces before and behind the cells of the line
  FaceDerivatives across_;       ///< along Y, of the face before each row and behind the last
};

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

/// Between rough surfaces the pressure of the oil changes by v - P_a' u: W_s -= V_s P_a' of node s.
template <class Real>
void add_asperities(const FilmState& state, FilmStencil<Real>& linear) {
  const Field<double>& slope = state.rough->asperity_slope;
  const int last = slope.nx() - 1;
  for (int i = 0; i <= last; ++i) {
    const double* here = slope.row(i);
    const std::array<const double*, neighbour_count> of = {slope.row(std::max(i - 2, 0)),
                                                           slope.row(std::max(i - 1, 0)),
                                                           here,
                                                           slope.row(std::min(i + 1, last)),
                                                           here - 1,
                                                           here + 1};
    for (int n = 0; n < neighbour_count; ++n) {
      const Real* by_pressure = linear.by_pressure[n].row(i);
      Real* by_thickness = linear.by_thickness[n].row(i);
      for (int j = 0; j < slope.y_count(); ++j) by_thickness[j] -= by_pressure[j] * static_cast<PartOf<Real>>(of[n][j]);
    }
  }
}

}  // namespace

template <class Real>
void linearise(const ReynoldsEquation& equation, ShiftOf<Real> shift, const FilmState& state,
               FilmStencil<Real>& linear) {
  const ScopedEvent event(Kernel::linearise);
  const int last = equation.grid.nx() - 1;
  linearise_edge(state, 0, linear);
  with_kinds(equation, state, [&]<FilmDiscretisation discretisation, class Line, bool with_rates>() {
    LineRows<Real, discretisation, Line, with_rates> rows(equation, state, shift);
    for (int i = 1; i < last; ++i) rows.find(i, linear);
  });
  linearise_edge(state, last, linear);
  if (state.rough) add_asperities(state, linear);
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

void apply_rates(const ReynoldsEquation& equation, const FilmState& state, const Field<double>& rates,
                 Field<double>& rows) {
  const int last = equation.grid.nx() - 1, count = equation.grid.y_count();
  const FaceWeights of_rates = state.of_rates;
  rows.fill(0.0);
  with_kinds(equation, state, [&]<FilmDiscretisation discretisation, class Line, bool with_rates>() {
    for (int i = 1; i < last; ++i) {
      const FlowAlongX<discretisation, Line, with_rates> before(equation, state, i - 1), behind(equation, state, i);
      const double *full_film = state.full_film.row(i), *ww = rates.row(std::max(i - 2, 0)), *w = rates.row(i - 1),
                   *own = rates.row(i), *e = rates.row(i + 1);
      double* out = rows.row(i);
      for (int j = 0; j < count; ++j) {
        const double out_of = of_rates.w * w[j] + of_rates.node_0 * own[j] + of_rates.node_1 * e[j];
        const double into = of_rates.w * ww[j] + of_rates.node_0 * w[j] + of_rates.node_1 * own[j];
        const double flows = behind.at(j).carried_only * out_of - before.at(j).carried_only * into;
        out[j] = full_film[j] * (own[j] + flows);
      }
    }
  });
}

template <class Real>
void displacement_column(const FilmStencil<Real>& linear, Field<Real>& column) {
  column.fill(Real(0));
  for (const Field<Real>& coefficient : linear.by_thickness) {
    for (int i = 0; i < column.nx(); ++i) {
      const Real* values = coefficient.row(i);
      Real* line = column.row(i);
      for (int j = 0; j < column.y_count(); ++j) line[j] += values[j];
    }
  }
}

template void linearise(const ReynoldsEquation&, double, const FilmState&, FilmStencil<float>&);
template void linearise(const ReynoldsEquation&, double, const FilmState&, FilmStencil<double>&);
template void linearise(const ReynoldsEquation&, std::complex<double>, const FilmState&,
                        FilmStencil<std::complex<double>>&);
template void displacement_column(const FilmStencil<float>&, Field<float>&);
template void displacement_column(const FilmStencil<double>&, Field<double>&);
template void displacement_column(const FilmStencil<std::complex<double>>&, Field<std::complex<double>>&);
template void apply_stencil(const FilmStencil<float>&, const Field<float>&, const Field<float>&, Field<float>&);
template void apply_stencil(const FilmStencil<double>&, const Field<double>&, const Field<double>&, Field<double>&);
template void apply_stencil(const FilmStencil<std::complex<double>>&, const Field<std::complex<double>>&,
                            const Field<std::complex<double>>&, Field<std::complex<double>>&);

}  // namespace gearfilm

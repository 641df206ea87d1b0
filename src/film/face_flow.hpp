// The flow of oil through the faces between nodes, and its derivatives by the pressures and films of the nodes.
//
// Through the face between node 0 and the next one, 1, along X, with W the node before 0; m = rho H (U + W):
//   flow/h_x = m_f/h_x - xi_f (P_1 - P_0)/h_x^2
// Fitted to oil whose fluidity phi changes by factors e to e^5 from node to node:
//   xi_f = rho_f H_f^3 phi_f ,  rho_f = (rho_0 + rho_1)/2 ,  phi_f = (phi_1 - phi_0)/ln(phi_1/phi_0)
//   H_f = 3/8 H_1 + 3/4 H_0 - 1/8 H_W
//   m_f = 3/2 m_0 - 1/2 m_W + theta 3/8 (m_1 - 2 m_0 + m_W)
//         + (1 - theta) h_x [1/3 (q_0 - q_1) + c (q_1 - 2 q_0 + q_W)] ,  q = d(rho H)/dT
//   theta = xi_f/(xi_f + 0.2 h_x^2 2 pi C_h (U + W)_0)
// The logarithmic mean is exact where ln phi is linear between the nodes. The wedge is upwind where oil is carried
// only, as waves are that travel with it, and of third order where oil conducts too: in the inlet, and behind the
// spike. Where oil is carried only, dm/dX = -q, so that rates tell how m bends: waves are carried with errors of third
// order, of fourth with c = 1/4, while a film that stands keeps the upwind wedge. Rates of order two are left out.
// H_f of the conducting gaps, between smooth surfaces H; m of rho [h (U + W) + slid] (film/rough_gap.hpp).
// Central: xi_f = (xi_0 + xi_1)/2, theta = 0. Both: the first face along X has means of H and m. Across, A_f the mean:
//   flow h_y = -A_f xi_f (P_1 - P_0) ,  H_f = (H_0 + H_1)/2
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "film/reynolds.hpp"
#include "lubricant/independent_iterations.hpp"

namespace gearfilm {

// Everything is inlined: loops over faces then use vector instructions.

/// A mean of phi, with its derivatives by ln phi.
struct LogarithmicMean {
  double value, by_log_0, by_log_1;
};
[[gnu::always_inline]] inline LogarithmicMean logarithmic_mean(double phi_0, double phi_1, double log_0, double log_1) {
  const double d = log_1 - log_0, square = 0.25 * d * d;
  const bool close = std::abs(d) < 0.01;  // where differences of phi have few digits: tanh(d/2)/(d/2) in powers of d
  const double inverse = 1.0 / (close ? 1.0 : d);
  const double value =
      close ? 0.5 * (phi_0 + phi_1) * (1.0 - square * (1.0 / 3.0 - (2.0 / 15.0) * square)) : (phi_1 - phi_0) * inverse;
  const double by_log_0 = close ? value * (0.5 - (1.0 / 12.0) * d) : (value - phi_0) * inverse;
  return {value, by_log_0, value - by_log_0};
}

/// xi_f, with its derivatives by P of the nodes 0 and 1 and by H of W, 0 and 1.
struct FaceConductance {
  double value, by_p_0, by_p_1, by_h_w, by_h_0, by_h_1;
};

/// Weights of the rates in the wedge, h_x left out. Differences of third order in time, in steps in which oil passes C
/// cells, leave waves the decay of 1/4 - c - C^3/4: all decay up to C = 0.6, and where oil is 1.2 times as fast.
inline FaceWeights rates_in_wedge(double C) {
  const double c = 0.23 - 0.5 * C * C * C;
  return {c, 1.0 / 3.0 - 2.0 * c, c - 1.0 / 3.0};
}

/// Conductance of the face between node j of line `a` and node m of line `b`, from H_f and its derivatives by H.
template <class Line>
[[gnu::always_inline]] inline FaceConductance fitted_conductance(const Line& a, int j, const Line& b, int m,
                                                                 double film, const FaceWeights& weights) {
  const double h = film > 0.0 ? film : 0.0, rho = 0.5 * (a.rho[j] + b.rho[m]), square = h * h, cube = h * square;
  const LogarithmicMean phi = logarithmic_mean(a.phi[j], b.phi[m], a.f[j], b.f[m]);
  const double by_h = 3.0 * rho * phi.value * square;
  return {rho * phi.value * cube,
          cube * (0.5 * a.rho_p[j] * phi.value + rho * phi.by_log_0 * a.f_p[j]),
          cube * (0.5 * b.rho_p[m] * phi.value + rho * phi.by_log_1 * b.f_p[m]),
          by_h * weights.w,
          by_h * weights.node_0,
          by_h * weights.node_1};
}

template <class Line>
[[gnu::always_inline]] inline FaceConductance central_conductance(const Line& a, int j, const Line& b, int m) {
  return {0.5 * (a.conductance(j) + b.conductance(m)), 0.5 * a.conductance_by_pressure(j),
          0.5 * b.conductance_by_pressure(m),          0.0,
          0.5 * a.conductance_by_thickness(j),         0.5 * b.conductance_by_thickness(m)};
}

/// A flow with its derivatives by P and H of the nodes W, 0 and 1.
struct FaceFlow {
  double value, by_p_w, by_p_0, by_p_1, by_h_w, by_h_0, by_h_1;
  double carried_only;  ///< 1 - theta, with which the weights of rates count; 0 through the first face along X
};

/// Through the faces between a line and the next one, over h_x. with_rates: whether there are rates in the wedge.
template <FilmDiscretisation discretisation, class Line = StateLine, bool with_rates = false>
class FlowAlongX {
public:
  /// Through the faces behind line i.
  FlowAlongX(const ReynoldsEquation& equation, const FilmState& state, int i)
      : w_(state, std::max(i - 1, 0)),
        here_(state, i),
        next_(state, i + 1),
        film_(i == 0 ? FaceWeights{0.0, 0.5, 0.5} : FaceWeights{-0.125, 0.75, 0.375}),
        upwind_(i == 0 ? FaceWeights{0.0, 0.5, 0.5} : FaceWeights{-0.5, 1.5, 0.0}),
        of_rates_(i == 0 ? FaceWeights{} : state.of_rates),
        inside_(i == 0 ? 0.0 : 1.0),
        bend_(i == 0 ? 0.0 : 0.375),
        inverse_h_x_(equation.inverse_h_x),
        inverse_h_x2_(equation.inverse_h_x2),
        carrying_(equation.carrying) {}

  [[gnu::always_inline]] FaceFlow at(int j) const {
    const double m_w = w_.carried(j), m_0 = here_.carried(j), m_1 = next_.carried(j);
    const FaceConductance xi = conductance(j);
    const double bend = bend_ * (m_1 - 2.0 * m_0 + m_w), slope = inverse_h_x2_ * (next_.p[j] - here_.p[j]);
    constexpr double smallest = 1e-100;  // of a divisor
    const double of_rates = rates_carried(j);
    double theta = 0.0, by_xi = -slope, carried_only = 0.0;
    if constexpr (discretisation == FilmDiscretisation::fitted) {
      const double inverse = 1.0 / (xi.value + carrying_ * std::abs(here_.entrained[j]) + smallest);
      theta = xi.value * inverse;
      by_xi += (inverse_h_x_ * bend - of_rates) * (1.0 - theta) * inverse;
      carried_only = inside_ * (1.0 - theta);
    }
    const double share = theta * bend_;
    const double c_w = inverse_h_x_ * (upwind_.w + share), c_0 = inverse_h_x_ * (upwind_.node_0 - 2.0 * share),
                 c_1 = inverse_h_x_ * (upwind_.node_1 + share);
    const double conducted = inverse_h_x2_ * xi.value;
    return {c_w * m_w + c_0 * m_0 + c_1 * m_1 + carried_only * of_rates - slope * xi.value,
            c_w * w_.carried_by_pressure(j),
            c_0 * here_.carried_by_pressure(j) + by_xi * xi.by_p_0 + conducted,
            c_1 * next_.carried_by_pressure(j) + by_xi * xi.by_p_1 - conducted,
            c_w * w_.carried_by_thickness(j) + by_xi * xi.by_h_w,
            c_0 * here_.carried_by_thickness(j) + by_xi * xi.by_h_0,
            c_1 * next_.carried_by_thickness(j) + by_xi * xi.by_h_1,
            carried_only};
  }

  /// The flow of volume that pressure drives, -(xi_f/rho_f) dP/dX.
  [[gnu::always_inline]] double driven(int j) const {
    return -inverse_h_x_ * conductance(j).value * (next_.p[j] - here_.p[j]) / (0.5 * (here_.rho[j] + next_.rho[j]));
  }

private:
  [[gnu::always_inline]] double rates_carried(int j) const {
    if constexpr (!with_rates) return 0.0;
    return of_rates_.w * w_.rate[j] + of_rates_.node_0 * here_.rate[j] + of_rates_.node_1 * next_.rate[j];
  }
  [[gnu::always_inline]] FaceConductance conductance(int j) const {
    if constexpr (discretisation == FilmDiscretisation::central) return central_conductance(here_, j, next_, j);
    const double film = film_.w * w_.g[j] + film_.node_0 * here_.g[j] + film_.node_1 * next_.g[j];
    return fitted_conductance(here_, j, next_, j, film,
                              {film_.w * w_.conducting_slope(j), film_.node_0 * here_.conducting_slope(j),
                               film_.node_1 * next_.conducting_slope(j)});
  }

  Line w_, here_, next_;
  FaceWeights film_, upwind_, of_rates_;
  double inside_, bend_, inverse_h_x_, inverse_h_x2_, carrying_;
};

/// Between node j of a line and node j + 1, without the distances of the rows; W is none. The line is one for flow
/// across.
template <FilmDiscretisation discretisation, class Line>
[[gnu::always_inline]] inline FaceFlow flow_along_y(const Line& line, int j) {
  const int m = j + 1;
  const auto flow = [&](const FaceConductance& xi, double A_0, double A_1) -> FaceFlow {
    const double difference = line.p[m] - line.p[j];
    return {-difference * xi.value,
            0.0,
            xi.value - difference * A_0 * xi.by_p_0,
            -xi.value - difference * A_1 * xi.by_p_1,
            0.0,
            -difference * A_0 * xi.by_h_0,
            -difference * A_1 * xi.by_h_1,
            0.0};
  };
  const double A_0 = line.across[j], A_1 = line.across[m];
  if constexpr (discretisation == FilmDiscretisation::central) {
    FaceConductance xi = central_conductance(line, j, line, m);
    xi.value = 0.5 * (A_0 * line.conductance(j) + A_1 * line.conductance(m));
    return flow(xi, A_0, A_1);
  } else {
    const double A = 0.5 * (A_0 + A_1);
    FaceConductance xi = fitted_conductance(line, j, line, m, 0.5 * (line.g[j] + line.g[m]),
                                            {0.0, 0.5 * line.conducting_slope(j), 0.5 * line.conducting_slope(m)});
    xi.value *= A;
    return flow(xi, A, A);
  }
}

/// Calls compute<discretisation, Line, with_rates>() for the discretisation of an equation, the surfaces of a state,
/// and whether there are rates in its wedge.
template <class Compute>
void with_kinds(const ReynoldsEquation& equation, const FilmState& state, Compute compute) {
  const auto of_surfaces = [&]<FilmDiscretisation discretisation, bool with_rates>() {
    if (state.rough || state.heights) {
      compute.template operator()<discretisation, LineOfState<true>, with_rates>();
    } else {
      compute.template operator()<discretisation, LineOfState<false>, with_rates>();
    }
  };
  if (equation.discretisation == FilmDiscretisation::central) {
    of_surfaces.template operator()<FilmDiscretisation::central, false>();
  } else if (state.of_rates.w == 0.0) {
    of_surfaces.template operator()<FilmDiscretisation::fitted, false>();
  } else {
    of_surfaces.template operator()<FilmDiscretisation::fitted, true>();
  }
}

}  // namespace gearfilm

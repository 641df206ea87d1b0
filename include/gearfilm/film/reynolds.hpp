// Reynolds' equation with cavitation on one grid: its residual.
//
//   R = -d/dX(xi_R dP/dX) - d/dY(xi_R dP/dY) + d(U rho H)/dX + d(rho H)/dT ,      P >= 0, R >= 0, P R = 0
// (22) of doi 10.1016/j.triboint.2013.01.017, sign reversed so that R and P form a complementarity problem.
// Poiseuille terms central with xi_R averaged at cell faces; wedge second-order upwind (first order in the first
// row); the squeeze term is given, so that any time scheme can supply it.
//
// Cavitation is written into the residual as G = min(d P, R) with the node's own scale
//   d = 2 xi_R/h_x^2 + xi_R (1/h_south + 1/h_north)/h_y + 0.05 (U/h_x + shift) ,
// shift = d(squeeze rate)/d(rho H) of the time scheme, h_south and h_north the distances of the neighbouring rows and
// h_y their mean:
// about dR/dP of the node alone: one scale for all nodes makes Newton cycle, and one that leaves out the squeeze term
// calls nodes cavitated that are not, the more of them the shorter the time step. Boundary nodes have G = d P.
#pragma once

#include <span>
#include <vector>

#include "gearfilm/film/film_state.hpp"

namespace gearfilm {

/// The squeeze term as a time scheme gives it.
struct Squeeze {
  std::span<const double> rate{};  ///< d(rho H)/dT of the own nodes, compact; empty for a stationary film
  double shift = 0.0;              ///< about d(rate)/d(rho H): sets the scale of cavitated rows
};

/// Weights of the equations that do not depend on the film, by own row where they depend on the row.
struct ReynoldsWeights {
  /// entrainment: U of the own rows.
  ReynoldsWeights(const Grid& grid, std::span<const double> entrainment, double scheme_shift = 0.0);

  /// d, the scale of a cavitated node's row.
  double row_scale(int j, double conductance) const {
    return conductance * (2.0 * inverse_h_x2 + south[j] + north[j]) + 0.05 * (inverse_h_x * U[j] + shift);
  }

  double inverse_h_x;
  double inverse_h_x2;
  std::vector<double> south, north;  ///< of the flow from the row before and to the next one: 1/(h_y h_south) ...
  std::span<const double> U;
  double shift;  ///< of the time scheme
};

/// Computes G on the own nodes, compact, and sets state.full_film and state.row_scale. Needs the ghosts of the state.
/// entrainment: U of the own rows, for d.
void reynolds_residual(const Grid& grid, std::span<const double> entrainment, FilmState& state, const Squeeze& squeeze,
                       std::span<double> residual);

}  // namespace gearfilm

// Reynolds' equation with cavitation on one grid: its residual.
//
//   R = -d/dX(xi_R dP/dX) - d/dY(xi_R dP/dY) + d(U rho H)/dX + d(rho H)/dT ,      P >= 0, R >= 0, P R = 0
// (22) of doi 10.1016/j.triboint.2013.01.017, sign reversed so that R and P form a complementarity problem.
// In finite volumes: what flows out of the cell of a node through its four faces (film/face_flow.hpp) and what it takes
// up; the squeeze term is given, so that any time scheme can supply it.
//
// Cavitation is written into the residual as G = min(d P, R) with the node's own scale
//   d = 2 xi_R/h_x^2 + xi_R (1/h_south + 1/h_north)/h_y + 0.05 (U/h_x + shift) ,
// shift = d(squeeze rate)/d(rho H) of the time scheme, h_south and h_north the distances of the neighbouring rows and
// h_y their mean:
// about dR/dP of the node alone: one scale for all nodes makes Newton cycle, and one that leaves out the squeeze term
// calls nodes cavitated that are not, the more of them the shorter the time step. Boundary nodes have G = d P.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/film_state.hpp"

namespace gearfilm {

/// How flows through faces follow from the nodes around them.
enum class FilmDiscretisation : std::uint8_t {
  fitted,  ///< means fitted to oil whose viscosity changes by factors from node to node
  central  ///< arithmetic means and a second-order upwind wedge, as in the paper
};

/// The squeeze term as a time scheme gives it.
struct Squeeze {
  std::span<const double> rate{};  ///< d(rho H)/dT of the own nodes, compact; empty for a stationary film
  double shift = 0.0;              ///< about d(rate)/d(rho H): sets the scale of cavitated rows

  /// Whether it is that very rate; an equal one elsewhere is another.
  bool is(const Squeeze& other) const {
    return rate.data() == other.rate.data() && rate.size() == other.rate.size() && shift == other.shift;
  }
};

/// What the equations of a grid have in common, whatever the film.
struct ReynoldsEquation {
  /// The grid must outlive it. C_h as in Scales.
  ReynoldsEquation(const Grid& on_grid, double C_h, FilmDiscretisation of_films);

  /// d, the scale of a cavitated node's row.
  double row_scale(int j, double conductance, double U, double shift) const {
    return conductance * (2.0 * inverse_h_x2 + south[j] + north[j]) + 0.05 * (inverse_h_x * U + shift);
  }

  const Grid& grid;
  FilmDiscretisation discretisation;
  double inverse_h_x;
  double inverse_h_x2;
  double carrying;                   ///< conductance over U of a face through which as much oil is carried as conducted
  std::vector<double> south, north;  ///< by own row, of the flow from the row before and to the next one:
                                     ///< 1/(h_y h_south), 1/(h_y h_north); zero in a line contact
};

/// Whether oil flows so freely at a node that a change of its pressure changes its row by what is conducted, not by
/// what is deformed. weight: d without conductance over the node's own.
inline bool conducts_freely(float weight) { return weight < 0.1F; }

/// Computes G on the own nodes, compact, and sets rate, full_film and row_scale of the state, whose ghosts it needs.
/// entrainment: U of the own rows, for d.
void reynolds_residual(const ReynoldsEquation& equation, std::span<const double> entrainment, FilmState& state,
                       const Squeeze& squeeze, std::span<double> residual);

/// The flow of volume that pressure drives along X at the nodes of line i, -(xi_R/rho) dP/dX. Central: with xi_R and
/// the central difference of the node. Fitted: the mean of those through both faces, or the node's own where that is
/// smaller, and none where they have opposite signs: beside a spike a node's own exceeds what flows by far. Nodes of
/// the first and the last line have none.
void poiseuille_flow(const ReynoldsEquation& equation, const FilmState& state, int i, std::span<double> flow);

}  // namespace gearfilm

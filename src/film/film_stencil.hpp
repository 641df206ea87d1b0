// Reynolds' equation linearised about a film state, as one stencil in the changes of pressure and film.
//
// For a change v of P and u of H the flows through the faces change as face_flow.hpp says, rho H by rho_P H v + rho u,
// and its rate, in the wedge too, by the time scheme's shift times that: the row of a full node is  dR = sum_s ( V_s
// v_s + W_s u_s )  over the nodes s = i-2, i-1, i, i+1 of its own x-line and its two y-neighbours; the row of a
// cavitated or boundary node is d v. Exact where P = 0 at cavitated nodes, as at every solution: only the derivative of
// their scale d is left out. Between rough surfaces the pressure of the oil changes by v - P_a' u: V_s and W_s are
// those of v and u, so W_s holds asperities too.
#pragma once

#include <array>
#include <complex>

#include "film/reynolds.hpp"

namespace gearfilm {

/// Neighbours in the stencil of a node.
enum Neighbour { west_west, west, centre, east, south, north, neighbour_count };

/// Type of the time scheme's shift s: real for time steps, complex for films that oscillate.
template <class Real>
using ShiftOf = std::conditional_t<std::is_floating_point_v<Real>, double, std::complex<double>>;

/// Type of the real and imaginary parts of a value; of a real value its own type.
template <class Real>
using PartOf = std::conditional_t<std::is_floating_point_v<Real>, Real, double>;

template <class Real>
struct FilmStencil {
  explicit FilmStencil(const Grid& grid)
      : by_pressure{Field<Real>(grid), Field<Real>(grid), Field<Real>(grid),
                    Field<Real>(grid), Field<Real>(grid), Field<Real>(grid)},
        by_thickness(by_pressure) {}

  std::array<Field<Real>, neighbour_count> by_pressure;   ///< V_s
  std::array<Field<Real>, neighbour_count> by_thickness;  ///< W_s
};

/// Fills the stencil from a state with ghosts and full-film mask. shift: d(dT-rate)/d(rho H) of the time scheme,
/// 0 for a stationary film, the complex s of exp(s T) for one that oscillates.
template <class Real>
void linearise(const ReynoldsEquation& equation, ShiftOf<Real> shift, const FilmState& state,
               FilmStencil<Real>& linear);

/// The derivative of the rows by the rates d(rho H)/dT, times a field of rates.
void apply_rates(const ReynoldsEquation& equation, const FilmState& state, const Field<double>& rates,
                 Field<double>& rows);

/// rows = sum_s V_s v_s + W_s u_s on the own nodes; v and u need their ghosts.
template <class Real>
void apply_stencil(const FilmStencil<Real>& linear, const Field<Real>& v, const Field<Real>& u, Field<Real>& rows);

/// The derivative of the rows by H_0 (u = 1 everywhere, v = 0).
template <class Real>
void displacement_column(const FilmStencil<Real>& linear, Field<Real>& column);

}  // namespace gearfilm

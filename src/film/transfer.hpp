// Transfer between a grid and its coarsening by two, along both directions or one.
//
// Full weighting (1/4 1/2 1/4 in either direction that is coarsened) for residuals, bilinear interpolation for
// corrections, injection for states. Cavitated and boundary nodes neither give nor receive.
#pragma once

#include "film/film_state.hpp"

namespace gearfilm {

/// coarse = full weighting of fine; fine needs its ghosts. Zero at coarse nodes that are not full.
template <class Real>
void restrict_residual(const Grid& fine_grid, const Grid& coarse_grid, const Field<Real>& fine,
                       const Field<Real>& coarse_full_film, Field<Real>& coarse);

/// fine += bilinear interpolation of coarse at full nodes; coarse needs its ghosts.
template <class Real>
void add_interpolated(const Grid& coarse_grid, const Grid& fine_grid, const Field<Real>& coarse,
                      const Field<Real>& fine_full_film, Field<Real>& fine);

/// fine = cubic interpolation of coarse (own nodes), for first guesses of smooth fields.
void interpolate_cubic(const Grid& coarse_grid, const Grid& fine_grid, const Field<double>& coarse,
                       Field<double>& fine);

/// Local fine row at the place of the local coarse row J.
int injected_row(const Grid& fine_grid, const Grid& coarse_grid, int J);

/// coarse = fine at the same points (own nodes).
void inject(const Grid& fine_grid, const Grid& coarse_grid, const Field<double>& fine, Field<double>& coarse);

/// A state of which every field is the fine one at the same point; with ghosts.
FilmState injected_state(const Grid& fine_grid, const Grid& coarse_grid, const Halo& coarse_halo,
                         const FilmState& fine);

}  // namespace gearfilm

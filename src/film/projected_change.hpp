// A step of Newton's method that would leave pressures below zero.
//
// At the edge of the full film such nodes fall dry. Their pressures become zero in the place of what the linear solve
// wants, and the rows of their neighbours, which were solved with that, are far from zero: where the edge moves, a few
// nodes often have nearly all of a film's residual and cost an iteration of their own. The linearised film, V v = R
// (film_stencil.hpp), is therefore solved as the problem of complementarity that it belongs to: what is added to the
// change v is the e of
//
//   sum_s V_s e_s = 0   or   P - v - e = 0 ,    P - v - e >= 0
//
// by a few sweeps of projected Gauss and Seidel around these nodes. The film is taken as it is: small pressures deform
// nothing.
#pragma once

#include <span>

#include "film/film_stencil.hpp"

namespace gearfilm {

/// Makes a change of the pressures (the new ones are pressure - change), both compact, such a one, at nodes that
/// conduct freely by their weights. added: e, scratch. Each process sees to its own rows as if their neighbours changed
/// as they were to; not collective.
template <class Real>
void project_change(const Grid& grid, const FilmStencil<Real>& linear, std::span<const double> pressure,
                    std::span<const float> weights, Field<Real>& added, std::span<double> change);

}  // namespace gearfilm

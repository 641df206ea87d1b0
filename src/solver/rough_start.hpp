// First guesses of films between rough surfaces.
//
// Dry, with P = P_a(H) at every node, rough surfaces have one smooth contact, which Newton's method finds from the
// Hertz pressure. Oil can leave in one iteration but comes back by a node at a time: the surfaces are then parted by
// about sigma, so that oil carries everywhere at first.
#pragma once

#include "solver/stationary_newton.hpp"

namespace gearfilm {

/// The film of a rough contact under the load condition, by Newton's method from its dry contact, parted by several
/// distances in turn. `guess`: pressure of the smooth dry contact; then the film, or the last iterate where false.
bool solve_from_dry_contact(StationaryNewton& newton, ContactFilm& film, const LoadCondition& load,
                            FilmSolution& guess);

}  // namespace gearfilm

// The error of the larger Floquet multiplier mu [-] of a periodic state on films that comes from the grid of its films.
//
// f [-] is the relative error that is expected of a film on that grid, of the central or the smallest film, whichever
// is larger (expected_errors.hpp).
//
// By Liouville's formula the product of all multipliers tells the damping alone, and so does each of a complex pair;
// real ones depend on the stiffness and its phase as well. With r = min(f/0.04, 1)^2, the larger multiplier mu has
//   |d log |mu|| = 0.3 r |log |mu||   where it is one of a complex pair
//   |d log |mu|| = 0.2 r              where it is real
// Bounds of 47 random pairs on half their nodes against all of them, and of 11 on these against finer grids.
#pragma once

#include "film/expected_errors.hpp"
#include "orbits/monodromy.hpp"
#include "orbits/orbit_search.hpp"

namespace gearfilm {

/// Relative, expected of the films on the problem's grid at the pitch point.
FilmErrors film_errors(const OrbitProblem& problem);

/// What the problem's grid, with which the multipliers were found, has wrong of the larger modulus [-]; the law above.
double multiplier_grid_error(const OrbitProblem& problem, const Multipliers& multipliers);

}  // namespace gearfilm

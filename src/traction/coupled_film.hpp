// The stationary film of one contact that feels its heat, its shear or both: film and corrections by turns.
//
//   (P, H_0) with theta, W, r, kappa, A,  these from T with the flow of the film,  until both stay as they are
// Temperatures and correction move by 0.8 of the way to what the next sweep makes of them, the last turns mixed
// (anderson_mixing.hpp) once the film is near.
// Where Newton's method does not find the film a quarter of the way is tried. The slowest to settle is the oil that
// turns round in the inlet: it loses its heat in many rounds only.
#pragma once

#include "solver/stationary.hpp"
#include "traction/traction.hpp"

namespace gearfilm {

struct CoupledFilm {
  StationaryResult film;
  Traction traction;
  FilmHeat heat;
  int turns = 0;        ///< sweeps over the temperatures
  int newton = 0;       ///< iterations of all films
  double change = 0.0;  ///< of the film in the last turns, relative
};

/// From the film without heat and shear. The film keeps its correction. Collective. Throws SolveError.
CoupledFilm solve_coupled(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                          const TractionModel& model, const StationaryResult& isothermal);

}  // namespace gearfilm

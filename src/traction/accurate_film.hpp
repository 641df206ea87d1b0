// The stationary film of one contact as accurate as asked for: solved on a grid, with its heat and shear where it feels
// them, compared with coarser grids, and solved once more on a finer grid where that says so.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "film/contact_film.hpp"
#include "film/discretisation.hpp"
#include "solver/grid_error.hpp"
#include "traction/coupled_film.hpp"

namespace gearfilm {

struct ContactProblem {
  Scales scales;
  ContactConditions conditions;
  LoadCondition load;
  FilmDiscretisation discretisation = FilmDiscretisation::fitted;
  SolverOptions solver;
  std::optional<TractionModel> traction{};  ///< absent: no friction is computed
  std::string label;                        ///< where it is, for messages
};

/// The film of the contact on one grid.
struct SolvedContact {
  std::unique_ptr<ContactFilm> film;
  StationaryResult result;           ///< with heat and shear, where the film feels them
  std::optional<GridErrors> errors;  ///< of that
  std::optional<CoupledFilm> coupled;
  FilmQuantities bare{};  ///< without heat and shear, where the film feels them
};

/// Throws SolveError where there is no film or none within the model's validity. Collective, as is the other.
SolvedContact solve_contact(const Grid& grid, const ContactProblem& problem);

/// On the grid, or on one finer by the factor that errors in films above `accuracy` ask for, a doubling of the nodes at
/// most: the grid may rest on a fitted law, and what its film says of itself counts more.
SolvedContact solve_contact_accurately(const Grid& grid, const ContactProblem& problem, double accuracy);

/// Friction and temperatures of the film; empty where none is computed.
Traction traction_of(const ContactProblem& problem, const SolvedContact& solved);

}  // namespace gearfilm

// What follows a film in time beside its pressure, and is part of its contact's state: heat and shear that change its
// flow (heat_process.hpp).
//
// A process advances after each accepted time step, with the film at the state of the step's end, and at no other time;
// its state is kept among the fields of the contact (contact_fields.hpp).
#pragma once

#include <memory>
#include <vector>

#include "dynamics/contact_fields.hpp"
#include "mesh/mesh_model.hpp"
#include "solver/stationary.hpp"
#include "traction/traction.hpp"

namespace gearfilm {

class FilmProcess {
public:
  virtual ~FilmProcess() = default;

  /// For a contact that begins with a stationary film: makes film and process stationary together; `found`, the film
  /// without the process, is then the common one. Collective. Throws SolveError.
  virtual void begin(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                     StationaryResult& found) = 0;
  /// Advances the process over a time step of dT, at whose end the film is, and prepares the film for the next step.
  /// Collective. Throws SolveError.
  virtual void advance(ContactFilm& film, double dT) = 0;

  /// Adds the state to the fields of a contact on this grid.
  virtual void save(const Grid& grid, ContactFields& fields) const = 0;
  /// Takes the state from them, and prepares the film for it.
  virtual void restore(ContactFilm& film, const ContactFields& fields) = 0;

  /// Friction and temperatures of the film at its present state, where the process knows them; else null. Collective.
  virtual std::shared_ptr<const Traction> traction(const ContactFilm& film) const = 0;
};

/// Makes the processes that follow each film of a pair; they have not begun yet.
std::vector<std::shared_ptr<FilmProcess>> film_processes(const MeshModel& mesh);

}  // namespace gearfilm

// A tooth contact that is being computed: its film, the fields that it carries in time, and what follows the film.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "dynamics/film_process.hpp"
#include "dynamics/stress_recorder.hpp"

namespace gearfilm {

/// Friction and temperatures at the last time at which they were asked for.
struct StepFriction {
  double T = -HUGE_VAL;
  std::shared_ptr<const Traction> known{};
};

struct ActiveContact {
  int number = 0;                                         ///< of the tooth pair, counted from the leading one at T = 0
  ContactFilm* film = nullptr;                            ///< at its present state; null in the dry model
  ContactFields fields{};                                 ///< as the last segment left them
  std::vector<std::shared_ptr<FilmProcess>> processes{};  ///< that follow the film
  std::shared_ptr<StressRecorder> stress{};               ///< below it; null where nobody asks
  std::shared_ptr<StepFriction> friction = std::make_shared<StepFriction>();
};

/// A contact that begins with a stationary film, which `found` is; with the film and its processes in equilibrium
/// `found` is the common one. Collective. Throws SolveError.
ActiveContact begin_contact(const MeshModel& mesh, int number, ContactFilm* film, const LoadCondition& load,
                            const SolverOptions& options, StationaryResult& found);

/// A contact that goes on with these fields, the states of its processes among them.
ActiveContact continue_contact(const MeshModel& mesh, int number, ContactFilm* film, ContactFields fields);

/// Takes the states of its processes from the contact's fields.
void restore_processes(ActiveContact& contact);

/// Puts the states of its processes among the contact's fields, and goes on with what is kept there, to the bit.
void save_processes(ActiveContact& contact);

/// Friction and temperatures of a contact's film at its present state: of the process that knows them, else of the film
/// alone. Collective.
std::shared_ptr<const Traction> traction_of(const TractionModel& model, const ActiveContact& contact);

/// Friction and heat of a contact's film as contact_records left them at time T. Collective.
std::shared_ptr<const Traction> friction_of_step(const TractionModel& model, const ActiveContact& contact, double T);

std::vector<int> numbers_of(const std::vector<ActiveContact>& contacts);

}  // namespace gearfilm

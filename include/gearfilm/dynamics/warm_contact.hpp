// Contacts whose films feel their heat, where they begin and where they go on.
#pragma once

#include "gearfilm/dynamics/step_record.hpp"
#include "gearfilm/traction/coupled_film.hpp"

namespace gearfilm {

inline bool corrects_films(const MeshModel& mesh) { return mesh.traction && mesh.traction->corrects_film(); }

/// A contact that begins with a stationary film: where films feel their heat, with the warm one, which
/// `found` then is too. Collective. Throws SolveError.
LiveContact begin_contact(const MeshModel& mesh, int number, ContactFilm* film, const LoadCondition& load,
                          const SolverOptions& options, StationaryResult& found);

/// Takes up the heat that is among the contact's fields, if films feel it.
void take_up_heat(const MeshModel& mesh, LiveContact& contact);

/// Puts the contact's heat among its fields, and goes on with what is kept there, to the bit.
void put_down_heat(const MeshModel& mesh, LiveContact& contact);

}  // namespace gearfilm

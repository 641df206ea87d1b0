// The heat of a film that feels it, along a march: part of a contact's state.
//
// After each time step the energy equation is solved for that step, and the film has the flow that its temperatures
// make in the next one. Among the fields of a contact the temperatures are beta (T - T_0), beside what they make of the
// flow.
#pragma once

#include "gearfilm/dynamics/contact_fields.hpp"
#include "gearfilm/traction/traction.hpp"

namespace gearfilm {

struct LiveHeat {
  FilmHeat state;
  std::optional<Traction> traction{};  ///< of the last time step; none where there was none
};

/// The state as fields, and back; rows: of the contact's own nodes.
void keep_heat(const TractionModel& model, const FilmHeat& heat, std::size_t rows, ContactFields& fields);
FilmHeat kept_heat(const TractionModel& model, const ContactFields& fields, std::size_t rows);

}  // namespace gearfilm

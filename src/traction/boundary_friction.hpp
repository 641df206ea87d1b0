// Friction of the asperities between rough surfaces.
//
//   tau_b = mu_b p_a tanh(1000 u_s/u_m)        p_a = p - p_f, the pressure that the oil does not carry
// The sign of sliding is continuous, so that nothing jumps at the pitch point. The heat tau_b u_s arises where the
// surfaces touch and goes into both by halves (an assumption), not through the oil.
#pragma once

#include <vector>

#include "film/contact_film.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// tau_b [Pa] of the own nodes, compact; empty between smooth surfaces.
std::vector<double> boundary_stress(const TractionModel& model, const ContactFilm& film);

}  // namespace gearfilm

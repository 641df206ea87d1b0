// Friction, losses and temperatures of one contact.
//
//   t_1 = -(tau_m + h p_x/2),  t_2 = tau_m - h p_x/2          traction on pinion and wheel along +x
//   F_s = Int Int tau_m,  F_r = Int Int h p_x/2,  F_1 = -F_s - F_r,  F_2 = F_s - F_r,  mu = F_s/F
//   power lost = Int Int (u_s tau_m + u_m h p_x) = u_s F_s + 2 u_m F_r where all rows move alike
// tau_m is zero where the film is cavitated. It has the sign of the sliding velocity, which is that of xi. Between
// rough surfaces h is the mean gap, p in h p_x the pressure of the oil, and asperities add their friction tau_b
// (boundary_friction.hpp): F_s = Int Int (tau_m + tau_b).
#pragma once

#include "traction/film_heat.hpp"

namespace gearfilm {

/// SI; forces, powers and heats of a line contact by unit length.
struct TractionQuantities {
  double sliding_force = 0.0;  ///< F_s [N]
  double rolling_force = 0.0;  ///< F_r [N]
  double coefficient = 0.0;    ///< mu; 0 without force
  double power_sliding = 0.0;  ///< u_s F_s [W]
  // Asperities' part of them.
  double boundary_force = 0.0;        ///< [N]
  double boundary_coefficient = 0.0;  ///< its part of mu
  double power_boundary = 0.0;        ///< [W]
  double power_rolling = 0.0;         ///< 2 u_m F_r [W]
  /// Largest rise of the surfaces' temperature if both had the same, all heat of sliding going into them [K].
  double flash = 0.0;
  // With heat only.
  double surface_pinion = 0.0;  ///< largest temperatures [K]
  double surface_wheel = 0.0;
  double film_mean = 0.0;  ///< of the mean over the film
  double film_max = 0.0;
  double heat_pinion = 0.0;  ///< into the bodies, and away with the oil [W]
  double heat_wheel = 0.0;
  double heat_oil = 0.0;
  double unconverged_fraction = 0.0;  ///< part of the loaded nodes whose temperatures did not settle
  double energy_residual = 0.0;       ///< what is generated and goes nowhere, over what is generated [-]
};

/// With powers and heats so many times as large: of a whole tooth whose contact carries a part of its force.
TractionQuantities with_powers_times(double factor, TractionQuantities quantities);

struct Traction {
  TractionQuantities quantities;
  TractionFields fields;
};

/// Friction and heat of a film at its present state. Collective. Throws SolveError where temperatures are not found.
Traction traction(const TractionModel& model, const ContactFilm& film);

/// The same of a film that feels its heat or its shear, with what both make of its flow: one sweep over the
/// temperatures.
Traction coupled_traction(const TractionModel& model, const ContactFilm& film, FilmHeat& heat,
                          std::optional<double> time_step = {});

}  // namespace gearfilm

// Heat in the film of one contact: the energy equation across it, marched along the entrainment, between surfaces that
// the heat warms as they pass.
//
// The equation across the film stands in film_energy_equation.hpp. Here: upwind along x; the Poiseuille flow as
// Reynolds' equation fixed it, q_P = -F h^3 p_x/(12 eta(p, T_0)); the surfaces by moving_source.hpp, implicit in the
// heat at the place itself. Where the film is cavitated the oil that went past the last full node fills a part of the
// gap, and conducts by that part. Oil enters with T_0, surfaces with the temperatures of their bodies. Stationary: in a
// march, that of the film at the moment. A film that does not feel its heat: u(z) carries the mass flow rho (u_m h +
// q_P), a tenth of rho u_m h at least; steps of first order. One that does (FlowProfile::thermal): its own flow, which
// may turn back in the inlet and brings the temperatures of the sweep before from there; steps of second order, (3 T_i
// - 4 T_i-1 + T_i-2)/(2 h_x).
#pragma once

#include <optional>
#include <vector>

#include "film/contact_film.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// Compact fields of a contact's own nodes, SI.
struct TractionFields {
  std::vector<double> shear_stress;     ///< tau_m, of the sign of u_s [Pa]
  std::vector<double> boundary_stress;  ///< tau_b of asperities likewise; empty between smooth surfaces
  // With heat only; empty without.
  std::vector<double> temperature_pinion;  ///< [K]
  std::vector<double> temperature_wheel;
  std::vector<double> temperature_mean;  ///< over the film
  std::vector<double> temperature_mid;   ///< at z = h/2
  std::vector<double> temperature_max;   ///< across the film
  std::vector<double> heat_flux_pinion;  ///< from film and asperities [W/m^2]
  std::vector<double> heat_flux_wheel;
  std::vector<double> heat_generated;   ///< in the film [W/m^2]
  std::vector<double> heat_carried;     ///< away by the oil [W/m^2]
  std::vector<double> log_flow_factor;  ///< ln F of a film that feels its heat; empty without
  std::vector<double> across;           ///< T_k along y = 0, line after line, where that row is; else empty
  double unconverged_nodes = 0.0;       ///< own nodes whose temperatures were not found to the last digit
};

/// Temperatures and heat of a film at its present state that does not feel them. Throws SolveError where a temperature
/// is not found.
TractionFields heated_film(const TractionModel& model, const ContactFilm& film);

/// The heat of a film, and what heat and shear make of the flow, from one sweep to the next.
struct FilmHeat {
  std::vector<double> temperatures;  ///< T_k of every own node, the wheel's wall first: on each line point after
                                     ///< point, row after row; empty before the first sweep, and where the film does
                                     ///< not feel its heat
  std::vector<double> passing;       ///< rho/rho_0 h u_k likewise [m^2/s]
  FlowFactors flow;                  ///< that these temperatures make
};

/// Where FilmHeat has the rows of a line, so many, at a point across the film.
inline std::size_t rows_at_point(std::size_t line, std::size_t point, std::size_t points, std::size_t rows) {
  return (line * points + point) * rows;
}

/// One sweep over the film at its present state, solved with film.flow_factors(); the heat after a time step [s], or,
/// with none, what it tends to. Throws SolveError likewise.
TractionFields sweep_heat(const TractionModel& model, const ContactFilm& film, FilmHeat& heat,
                          std::optional<double> time_step = {});

}  // namespace gearfilm

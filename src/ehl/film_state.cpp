#include "gearfilm/ehl/film_state.hpp"

#include <cmath>

#include "gearfilm/ehl/events.hpp"

namespace gearfilm {

void FilmProperties::evaluate(FilmState& state) const {
  const ScopedEvent event(Kernel::film_properties);
  for (int i = 0; i < state.pressure.nx(); ++i) {
    const double* pressure = state.pressure.row(i);
    const double* film = state.film.row(i);
    for (int j = 0; j < state.pressure.y_count(); ++j) {
      const PressureFunction density = relative_density(oil_, pressure_scale_ * pressure[j]);
      const PressureFunction log_viscosity = log_relative_viscosity(oil_, pressure_scale_ * pressure[j]);
      const double h = std::max(film[j], 0.0);
      const double rho_over_eta_lambda = density.value * std::exp(-log_viscosity.value) / lambda_;
      const double conductance = rho_over_eta_lambda * h * h * h;
      state.density.row(i)[j] = density.value;
      state.density_by_pressure.row(i)[j] = pressure_scale_ * density.derivative;
      state.conductance.row(i)[j] = conductance;
      state.conductance_by_pressure.row(i)[j] =
          pressure_scale_ * conductance * (density.derivative / density.value - log_viscosity.derivative);
      state.conductance_by_film.row(i)[j] = 3.0 * rho_over_eta_lambda * h * h;
    }
  }
}

void exchange_ghosts(const Halo& halo, FilmState& state) {
  halo.exchange(state.pressure);
  halo.exchange(state.conductance);
  halo.exchange(state.conductance_by_pressure);
  halo.exchange(state.conductance_by_film);
}

}  // namespace gearfilm

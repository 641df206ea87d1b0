#include "gearfilm/ehl/film_state.hpp"

#include <cmath>

#include "gearfilm/lubricant/independent_iterations.hpp"
#include "gearfilm/parallel/events.hpp"

namespace gearfilm {

template <ViscosityLaw law>
void FilmProperties::evaluate_line(FilmState& state, int i, const double* thinning,
                                   const double* density_factor) const {
  const OilLaws laws = laws_;
  const double scale = pressure_scale_, inverse_lambda = inverse_lambda_, inverse_span = inverse_span_;
  const double* pressure = state.pressure.row(i);
  const double* film = state.thickness.row(i);
  double* density = state.density.row(i);
  double* density_by_pressure = state.density_by_pressure.row(i);
  double* conductance = state.conductance.row(i);
  double* conductance_by_pressure = state.conductance_by_pressure.row(i);
  double* conductance_by_thickness = state.conductance_by_thickness.row(i);
  const int count = state.pressure.y_count();
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const PressureFunction rho = laws.density(scale * pressure[j]);
    const PressureFunction log_eta = laws.log_viscosity<law>(scale * pressure[j]);
    const double h = film[j] > 0.0 ? film[j] : 0.0;
    const double by_film_squared =
        density_factor[j] * rho.value * exp(thinning[j] * (1.0 + inverse_span * log_eta.value) - log_eta.value) * inverse_lambda;
    const double xi = by_film_squared * h * h * h;
    density[j] = density_factor[j] * rho.value;
    density_by_pressure[j] = scale * density_factor[j] * rho.derivative;
    conductance[j] = xi;
    conductance_by_pressure[j] = scale * xi * (rho.derivative / rho.value - (1.0 - inverse_span * thinning[j]) * log_eta.derivative);
    conductance_by_thickness[j] = 3.0 * by_film_squared * h * h;
  }
}

void FilmProperties::evaluate(FilmState& state, const FlowCorrection& correction) const {
  const ScopedEvent event(Kernel::film_properties);
  const std::size_t rows = state.pressure.y_count();
  const std::vector<double> zeros(rows, 0.0), ones(rows, 1.0);  // a line without correction
  for (int i = 0; i < state.pressure.nx(); ++i) {
    const double* thinning = correction.empty() ? zeros.data() : correction.thinning.data() + i * rows;
    const double* density = correction.empty() ? ones.data() : correction.density.data() + i * rows;
    if (viscosity_law_ == ViscosityLaw::barus) {
      evaluate_line<ViscosityLaw::barus>(state, i, thinning, density);
    } else {
      evaluate_line<ViscosityLaw::roelands>(state, i, thinning, density);
    }
  }
}

void exchange_ghosts(const Halo& halo, FilmState& state) {
  halo.exchange(state.pressure, state.conductance, state.conductance_by_pressure, state.conductance_by_thickness);
}

}  // namespace gearfilm

#include "gearfilm/film/film_state.hpp"

#include <cmath>

#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {

// The laws are copied: nothing that the loop writes can change them.
template <EvaluatesViscosity Viscosity, EvaluatesDensity Density>
void FilmProperties::evaluate_line(Viscosity viscosity, Density density_law, FilmState& state, int i) const {
  const double scale = pressure_scale_, inverse_lambda = inverse_lambda_;
  const double* pressure = state.film_pressure().row(i);
  const double* film = state.thickness.row(i);
  double* density = state.density.row(i);
  double* density_by_pressure = state.density_by_pressure.row(i);
  double* conductance = state.conductance.row(i);
  double* conductance_by_pressure = state.conductance_by_pressure.row(i);
  double* conductance_by_thickness = state.conductance_by_thickness.row(i);
  const int count = state.film_pressure().y_count();
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const PressureFunction rho = density_law.density(scale * pressure[j]);
    const PressureFunction log_eta = viscosity.log_viscosity(scale * pressure[j]);
    const double h = film[j] > 0.0 ? film[j] : 0.0;
    const double by_film_squared = rho.value * exp(-log_eta.value) * inverse_lambda;
    const double xi = by_film_squared * h * h * h;
    density[j] = rho.value;
    density_by_pressure[j] = scale * rho.derivative;
    conductance[j] = xi;
    conductance_by_pressure[j] = scale * xi * (rho.derivative / rho.value - log_eta.derivative);
    conductance_by_thickness[j] = 3.0 * by_film_squared * h * h;
  }
}

/// ln xi_R gains ln F + ln S, which depend on the pressure by ln(eta/eta_0) alone.
template <bool sheared, EvaluatesViscosity Viscosity>
void FilmProperties::correct_line(Viscosity viscosity, FilmState& state, int i, const FlowFactors& factors) const {
  const double scale = pressure_scale_, power = factors.shear_power;
  const int count = state.film_pressure().y_count();
  const std::size_t first = static_cast<std::size_t>(i) * count;
  const double *thinning = factors.log_poiseuille.data() + first,
               *density_factor = factors.density_ratio.data() + first;
  const double *kappa = factors.shear_index.data() + first, *pressure = state.film_pressure().row(i);
  double* density = state.density.row(i);
  double* density_by_pressure = state.density_by_pressure.row(i);
  double* conductance = state.conductance.row(i);
  double* conductance_by_pressure = state.conductance_by_pressure.row(i);
  double* conductance_by_thickness = state.conductance_by_thickness.row(i);
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const PressureFunction log_eta = viscosity.log_viscosity(scale * pressure[j]);
    const HeatingRatio ratio = viscosity.heating_ratio(log_eta.value, scale * pressure[j]);
    const double log_F = thinning[j] * ratio.value, by_eta = ratio.derivative * thinning[j];
    LogShearFactor shear{};
    if constexpr (sheared) shear = log_shear_factor(power, kappa[j], log_eta.value - log_F);
    const double factor = density_factor[j] * exp(log_F + shear.value);
    const double slope = scale * log_eta.derivative * (by_eta + shear.derivative * (1.0 - by_eta));
    density[j] *= density_factor[j];
    density_by_pressure[j] *= density_factor[j];
    conductance_by_pressure[j] = factor * (conductance_by_pressure[j] + slope * conductance[j]);
    conductance[j] *= factor;
    conductance_by_thickness[j] *= factor;
  }
}

void FilmProperties::evaluate(FilmState& state, const FlowFactors& factors) const {
  const ScopedEvent event(Kernel::film_properties);
  const int lines = state.film_pressure().nx();
  std::visit(
      [&](const auto& viscosity, const auto& density) {
        for (int i = 0; i < lines; ++i) evaluate_line(viscosity, density, state, i);
      },
      viscosity_, density_);
  if (factors.empty()) return;
  std::visit(
      [&](const auto& viscosity) {
        for (int i = 0; i < lines; ++i) {
          factors.sheared ? correct_line<true>(viscosity, state, i, factors)
                          : correct_line<false>(viscosity, state, i, factors);
        }
      },
      viscosity_);
}

void exchange_ghosts(const Halo& halo, FilmState& state) {
  halo.exchange(state.film_pressure(), state.conductance, state.conductance_by_pressure,
                state.conductance_by_thickness);
  if (state.across) halo.exchange(*state.across);
}

}  // namespace gearfilm

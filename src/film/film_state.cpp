#include "film/film_state.hpp"

#include <algorithm>
#include <cmath>

#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {

// The laws are copied: nothing that the loop writes can change them.
template <EvaluatesViscosity Viscosity, EvaluatesDensity Density>
void FilmProperties::evaluate_line(Viscosity viscosity, Density density_law, FilmState& state, int i) const {
  const double scale = pressure_scale_, inverse_lambda = inverse_lambda_;
  const double* pressure = state.film_pressure().row(i);
  double* density = state.density.row(i);
  double* density_by_pressure = state.density_by_pressure.row(i);
  double* fluidity = state.fluidity.row(i);
  double* log_fluidity = state.log_fluidity.row(i);
  double* log_fluidity_by_pressure = state.log_fluidity_by_pressure.row(i);
  const int count = state.film_pressure().y_count();
  // Inside an iteration asperities may carry more than all the load.
  const double least = state.rough ? 0.0 : -HUGE_VAL;
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const double p = scale * std::max(pressure[j], least);
    const PressureFunction rho = density_law.density(p);
    const PressureFunction log_eta = viscosity.log_viscosity(p);
    density[j] = rho.value;
    density_by_pressure[j] = scale * rho.derivative;
    fluidity[j] = exp(-log_eta.value) * inverse_lambda;
    log_fluidity[j] = -log_eta.value;
    log_fluidity_by_pressure[j] = -scale * log_eta.derivative;
  }
}

/// ln phi gains ln F + ln S, which depend on the pressure by ln(eta/eta_0) alone.
template <bool sheared, EvaluatesViscosity Viscosity>
void FilmProperties::correct_line(Viscosity viscosity, FilmState& state, int i, const FlowFactors& factors) const {
  const double scale = pressure_scale_, power = factors.shear_power, inverse_lambda = inverse_lambda_;
  const int count = state.film_pressure().y_count();
  const std::size_t first = static_cast<std::size_t>(i) * count;
  const double *theta = factors.log_poiseuille.data() + first, *density_ratio = factors.density_ratio.data() + first;
  const double *kappa = factors.shear_index.data() + first, *pressure = state.film_pressure().row(i);
  double* density = state.density.row(i);
  double* density_by_pressure = state.density_by_pressure.row(i);
  double* fluidity = state.fluidity.row(i);
  double* log_fluidity = state.log_fluidity.row(i);
  double* log_fluidity_by_pressure = state.log_fluidity_by_pressure.row(i);
  const double least = state.rough ? 0.0 : -HUGE_VAL;
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < count; ++j) {
    const double log_eta = -log_fluidity[j];
    const HeatingRatio ratio = viscosity.heating_ratio(log_eta, scale * std::max(pressure[j], least));
    const double log_F = theta[j] * ratio.value, by_eta = ratio.derivative * theta[j];
    LogShearFactor shear{};
    if constexpr (sheared) shear = log_shear_factor(power, kappa[j], log_eta - log_F);
    const double log_phi = log_F + shear.value - log_eta;
    density[j] *= density_ratio[j];
    density_by_pressure[j] *= density_ratio[j];
    fluidity[j] = exp(log_phi) * inverse_lambda;
    log_fluidity[j] = log_phi;
    log_fluidity_by_pressure[j] *= 1.0 - by_eta - shear.derivative * (1.0 - by_eta);
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
  halo.exchange(state.film_pressure(), state.thickness, state.density, state.density_by_pressure, state.fluidity,
                state.log_fluidity, state.log_fluidity_by_pressure);
  if (state.across) halo.exchange(*state.across);
  if (state.rough) exchange_ghosts(halo, *state.rough);
}

}  // namespace gearfilm

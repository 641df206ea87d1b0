#include "dynamics/contact_quantities.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

double hertz_pressure_of(const QuantityInputs& at) {
  if (!(at.film.pressure_integral > 0.0)) return 0.0;
  return dry_contact(at.scales, at.contact.conditions, at.film.pressure_integral).pressure / at.scales.pressure;
}

AvailableModels available_models(bool lubricated, const std::optional<TractionModel>& traction,
                                 const std::optional<double>& roughness, const ContactSolids& solids,
                                 const std::optional<WearCoefficients>& wear,
                                 const std::optional<StressModel>& stress) {
  return {.film = lubricated,
          .friction = traction.has_value(),
          .heat = traction && traction->heat,
          .roughness = roughness.has_value(),
          .asperities = solids.rough != nullptr,
          .wear = wear.has_value(),
          .stress = stress.has_value()};
}

double asperity_load_share(const QuantityInputs& at) {
  return at.film.pressure_integral > 0.0 ? at.film.asperity_integral / at.film.pressure_integral : 0.0;
}

namespace {

double asperity_line_load(const QuantityInputs& at) {
  return at.film.asperity_line * at.scales.pressure * at.scales.length;
}

double asperity_force(const QuantityInputs& at) { return at.load_factor * at.scales.force(at.film.asperity_integral); }

}  // namespace

double pinion_wear(const QuantityInputs& at) {
  const SurfaceVelocities u = velocities_of(at.scales, at.contact);
  return at.wear ? wear_depth(at.wear->pinion, u.sliding, u.pinion(), asperity_line_load(at)) : 0.0;
}

double wheel_wear(const QuantityInputs& at) {
  const SurfaceVelocities u = velocities_of(at.scales, at.contact);
  return at.wear ? wear_depth(at.wear->wheel, u.sliding, u.wheel(), asperity_line_load(at)) : 0.0;
}

double pinion_wear_rate(const QuantityInputs& at) {
  return at.wear ? wear_rate(at.wear->pinion, velocities_of(at.scales, at.contact).sliding, asperity_force(at)) : 0.0;
}

double wheel_wear_rate(const QuantityInputs& at) {
  return at.wear ? wear_rate(at.wear->wheel, velocities_of(at.scales, at.contact).sliding, asperity_force(at)) : 0.0;
}

double film_ratio(const QuantityInputs& at) {
  return at.roughness ? at.scales.thickness * at.film.smallest_film / *at.roughness : 0.0;
}

ContactQuantities quantities_of(const QuantityInputs& at) {
  ContactQuantities quantities;
  for (std::size_t n = 0; n < contact_quantities.size(); ++n) quantities.values[n] = contact_quantities[n].value(at);
  return quantities;
}

FilmQuantities film_quantities(const ContactQuantities& quantities) {
  FilmQuantities film;
  film.pressure_integral = quantities["force"];
  film.central_film = quantities["h_central"];
  film.smallest_film = quantities["h_min"];
  film.central_pressure = quantities["p_central"];
  film.largest_pressure = quantities["p_max"];
  film.spike_pressure = quantities["p_spike"];
  film.asperity_integral = quantities["asperity_force"];
  film.central_mean_gap = quantities["mean_gap_central"];
  film.smallest_mean_gap = quantities["mean_gap_min"];
  film.largest_film_pressure = quantities["p_fluid_max"];
  film.largest_asperity_pressure = quantities["p_asperity_max"];
  film.finite = std::ranges::all_of(quantities.values, [](double value) { return std::isfinite(value); });
  return film;
}

}  // namespace gearfilm

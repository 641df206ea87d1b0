#include "dynamics/contact_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "contact/line_contact.hpp"

namespace gearfilm {

double hertz_pressure_of(const QuantityInputs& at) {
  if (!(at.film.pressure_integral > 0.0)) return 0.0;
  return dry_contact(at.scales, at.contact.conditions, at.film.pressure_integral).pressure / at.scales.pressure;
}

AvailableModels available_models(bool lubricated, const std::optional<TractionModel>& traction,
                                 const std::optional<double>& roughness, const ContactSolids& solids,
                                 const std::optional<WearCoefficients>& wear, const std::optional<StressModel>& stress,
                                 const RatingModel* rating) {
  return {.film = lubricated,
          .friction = traction.has_value(),
          .heat = traction && traction->heat,
          .roughness = roughness.has_value(),
          .asperities = solids.rough != nullptr,
          .asperity_area = solids.rough && solids.rough->asperities().knows_real_area(),
          .wear = wear.has_value(),
          .stress = stress.has_value(),
          .rating = rating != nullptr,
          .rated_root = rating && rating->roots,
          .rated_film = rating && rating->mean_roughness};
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

namespace {

/// On the tooth [N].
double tooth_force(const QuantityInputs& at) { return at.load_factor * at.scales.force(at.film.pressure_integral); }

}  // namespace

double rated_contact_stress(const QuantityInputs& at) {
  return at.rating ? at.rating->contact_stress(tooth_force(at), at.contact.position) : 0.0;
}

double rated_pinion_root(const QuantityInputs& at) {
  return at.rating ? at.rating->root_stress(0, tooth_force(at), at.contact.position) : 0.0;
}

double rated_wheel_root(const QuantityInputs& at) {
  return at.rating ? at.rating->root_stress(1, tooth_force(at), at.contact.position) : 0.0;
}

double rated_film_ratio(const QuantityInputs& at) {
  if (!at.rating) return 0.0;
  return at.rating->film_ratio(tooth_force(at), at.contact.position, velocities_of(at.scales, at.contact).mean);
}

double rated_temperature(const QuantityInputs& at) {
  if (!at.rating) return 0.0;
  const double warmer = std::max(at.traction.surface_pinion, at.traction.surface_wheel);
  return warmer > 0.0 ? warmer : at.rating->bulk_temperature + at.traction.flash;
}

double film_ratio(const QuantityInputs& at) {
  return at.roughness ? at.scales.thickness * at.film.smallest_film / *at.roughness : 0.0;
}

double central_film_ratio(const QuantityInputs& at) {
  return at.roughness ? at.scales.thickness * at.film.central_film / *at.roughness : 0.0;
}

double smooth_film_ratio(const QuantityInputs& at) {
  if (!at.roughness || !(at.film.pressure_integral > 0.0)) return 0.0;
  const ContactOperation operation{at.scales.force(at.film.pressure_integral),
                                   velocities_of(at.scales, at.contact).mean};
  return expected_central_film(solids_of(at.scales, at.contact.conditions), at.scales.oil, operation) / *at.roughness;
}

double real_area_ratio(const QuantityInputs& at) {
  const RoughSurfaces* rough = at.scales.solids.rough.get();
  if (!rough) return 0.0;
  return rough->asperities().real_area(at.scales.thickness * at.film.central_film / rough->sigma()).value_or(0.0);
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

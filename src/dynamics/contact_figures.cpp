#include "dynamics/contact_figures.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

double hertz_pressure_of(const ContactMoment& at) {
  if (!(at.film.pressure_integral > 0.0)) return 0.0;
  return dry_contact(at.scales, at.contact.conditions, at.film.pressure_integral).pressure / at.scales.pressure;
}

Given given_figures(bool lubricated, const std::optional<TractionModel>& traction,
                    const std::optional<double>& roughness) {
  return {.film = lubricated,
          .friction = traction.has_value(),
          .heat = traction && traction->heat,
          .roughness = roughness.has_value()};
}

double film_ratio(const ContactMoment& at) {
  return at.roughness ? at.scales.thickness * at.film.smallest_film / *at.roughness : 0.0;
}

ContactFigures figures_of(const ContactMoment& at) {
  ContactFigures figures;
  for (std::size_t n = 0; n < contact_figures.size(); ++n) figures.values[n] = contact_figures[n].value(at);
  return figures;
}

FilmFigures film_figures(const ContactFigures& figures) {
  FilmFigures film;
  film.pressure_integral = figures["force"];
  film.central_film = figures["h_central"];
  film.smallest_film = figures["h_min"];
  film.central_pressure = figures["p_central"];
  film.largest_pressure = figures["p_max"];
  film.spike_pressure = figures["p_spike"];
  film.finite = std::ranges::all_of(figures.values, [](double value) { return std::isfinite(value); });
  return film;
}

}  // namespace gearfilm

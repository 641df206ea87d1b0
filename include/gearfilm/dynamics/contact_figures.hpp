// The table of a contact's figures, one record each: a new figure is a new record (figure.hpp).
#pragma once

#include "gearfilm/dynamics/figure.hpp"
#include "gearfilm/dynamics/meshed_contact.hpp"
#include "gearfilm/ehl/contact_film.hpp"

namespace gearfilm {

/// What a contact's figures are computed from: one contact at one time.
struct ContactMoment {
  const Scales& scales;
  MeshedContact contact;
  FilmFigures film;  ///< of a dry contact: its pressure integral and pressures only
};

/// Largest pressure of the dry contact under the same force; zero without force.
double hertz_pressure_of(const ContactMoment& at);
inline constexpr auto contact_figures = std::to_array<Figure<ContactMoment>>({
    {.name = "force",
     .symbol = "w",
     .unit = units::newton,
     .value = [](const ContactMoment& at) { return at.film.pressure_integral; },
     .meaning = "force on the contact",
     .reduced = {{{"force_ratio_max", Reduction::largest, units::static_force,
                   "largest force on one contact over the static force", Shown::everywhere}}}},
    {.name = "p_max",
     .symbol = "p",
     .unit = units::pascal,
     .value = [](const ContactMoment& at) { return at.film.largest_pressure; },
     .meaning = "largest pressure",
     .reduced = {{{"p_max", Reduction::largest, units::pascal, "largest pressure", Shown::everywhere}}}},
    {.name = "p_central",
     .symbol = "p",
     .unit = units::pascal,
     .value = [](const ContactMoment& at) { return at.film.central_pressure; },
     .meaning = "pressure at x = y = 0",
     .needs = Needs::film},
    {.name = "h_central",
     .symbol = "h",
     .unit = units::metre,
     .value = [](const ContactMoment& at) { return at.film.central_film; },
     .meaning = "film thickness at x = y = 0",
     .needs = Needs::film,
     .reduced = {{{"pitch_h_central", Reduction::at_pitch, units::metre,
                   "central film at the step nearest to the pitch point"},
                  {"entry_h_central", Reduction::at_entry, units::metre,
                   "central film at the first step after a contact entered"}}}},
    {.name = "h_min",
     .symbol = "h",
     .unit = units::metre,
     .value = [](const ContactMoment& at) { return at.film.smallest_film; },
     .meaning = "smallest film thickness",
     .needs = Needs::film,
     .reduced = {{{"h_min", Reduction::smallest, units::metre, "smallest film thickness", Shown::everywhere},
                  {"pitch_h_min", Reduction::at_pitch, units::metre,
                   "smallest film at the step nearest to the pitch point"},
                  {"entry_h_min", Reduction::at_entry, units::metre,
                   "smallest film at the first step after a contact entered"}}}},
    {.name = "p_hertz",
     .symbol = "p_h",
     .unit = units::pascal,
     .value = hertz_pressure_of,
     .meaning = "Hertz pressure under the present force, zero without force",
     .reduced = {{{"p_hertz_max", Reduction::largest, units::pascal, "largest Hertz pressure under the present force",
                   Shown::everywhere}}}},
    {.name = "sliding_velocity",
     .symbol = "u_1 - u_2",
     .unit = units::velocity,
     .value = [](const ContactMoment& at) { return at.contact.sliding.value(); },
     .meaning = "surface velocity of the pinion less that of the wheel: negative before the pitch point, positive "
                "behind it",
     .needs = Needs::gears,
     .reduced = {{{"sliding_velocity_max", Reduction::largest, units::velocity,
                   "largest sliding velocity, of a contact behind the pitch point", Shown::everywhere},
                  {"sliding_velocity_min", Reduction::smallest, units::velocity,
                   "smallest sliding velocity, negative where a contact is before the pitch point",
                   Shown::everywhere}}}},
});

/// A figure by its name: one that does not exist ends the compilation.
struct ContactFigureName {
  consteval ContactFigureName(const char* name) : place(place_in(contact_figures, name)) {}
  std::size_t place;
};

/// Values of all figures of one contact, dimensionless, in the order of the table.
struct ContactFigures {
  std::array<double, contact_figures.size()> values{};

  double& operator[](ContactFigureName name) { return values[name.place]; }
  double operator[](ContactFigureName name) const { return values[name.place]; }
};

/// All that the moment has. Those of gears are zero for a bare contact.
ContactFigures figures_of(const ContactMoment& at);

/// What the film itself gave, out of the figures.
FilmFigures film_figures(const ContactFigures& figures);

}  // namespace gearfilm

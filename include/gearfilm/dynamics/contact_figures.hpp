// The table of a contact's figures, one record each: a new figure is a new record (figure.hpp).
#pragma once

#include <optional>

#include "gearfilm/dynamics/figure.hpp"
#include "gearfilm/film/contact_film.hpp"
#include "gearfilm/mesh/mesh_model.hpp"
#include "gearfilm/traction/traction.hpp"

namespace gearfilm {

/// What a contact's figures are computed from: one contact at one time.
struct ContactMoment {
  const Scales& scales;
  MeshedContact contact;
  FilmFigures film;  ///< of a dry contact: its pressure integral and pressures only
  TractionFigures traction{};
  std::optional<double> roughness{};  ///< of both flanks together [m]
};

/// Which figures there are.
Given given_figures(bool lubricated, const std::optional<TractionModel>& traction,
                    const std::optional<double>& roughness);
inline Given given_figures(const MeshModel& mesh, bool lubricated) {
  return given_figures(lubricated, mesh.traction, mesh.roughness);
}

/// h_min/Rq; zero without roughness.
double film_ratio(const ContactMoment& at);
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
    {.name = "p_spike",
     .symbol = "p",
     .unit = units::pascal,
     .value = [](const ContactMoment& at) { return at.film.spike_pressure; },
     .meaning = "height of the outlet's spike, where pressure rises once more behind its fall; zero where it does not",
     .needs = Needs::film,
     .reduced = {{{"p_spike_max", Reduction::largest, units::pascal, "largest height of the outlet's spike"}}}},
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
     .value = [](const ContactMoment& at) { return at.contact.conditions.sliding; },
     .meaning = "surface velocity of the pinion less that of the wheel: negative before the pitch point, positive "
                "behind it",
     .reduced = {{{"sliding_velocity_max", Reduction::largest, units::velocity,
                   "largest sliding velocity, of a contact behind the pitch point", Shown::everywhere},
                  {"sliding_velocity_min", Reduction::smallest, units::velocity,
                   "smallest sliding velocity, negative where a contact is before the pitch point",
                   Shown::everywhere}}}},
    {.name = "lambda",
     .symbol = "h_min/Rq",
     .value = film_ratio,
     .meaning = "smallest film over the roughness of both flanks together",
     .needs = Needs::roughness,
     .reduced = {{{"lambda_min", Reduction::smallest, units::number, "smallest film over the roughness",
                   Shown::everywhere}}}},
    {.name = "friction_force",
     .symbol = "F_s",
     .unit = units::si_newton,
     .value = [](const ContactMoment& at) { return at.traction.sliding_force; },
     .meaning = "force of sliding friction, with the sign of the sliding velocity",
     .needs = Needs::friction},
    {.name = "rolling_force",
     .symbol = "F_r",
     .unit = units::si_newton,
     .value = [](const ContactMoment& at) { return at.traction.rolling_force; },
     .meaning = "force of rolling friction on either flank",
     .needs = Needs::friction},
    {.name = "friction_coefficient",
     .symbol = "mu",
     .value = [](const ContactMoment& at) { return at.traction.coefficient; },
     .meaning = "friction_force over the force on the contact",
     .needs = Needs::friction},
    {.name = "power_sliding",
     .symbol = "u_s F_s",
     .unit = units::watt,
     .value = [](const ContactMoment& at) { return at.traction.power_sliding; },
     .meaning = "power lost by sliding",
     .needs = Needs::friction},
    {.name = "power_rolling",
     .symbol = "2 u_m F_r",
     .unit = units::watt,
     .value = [](const ContactMoment& at) { return at.traction.power_rolling; },
     .meaning = "power lost by rolling: of the oil that pressure drives",
     .needs = Needs::friction},
    {.name = "flash_temperature",
     .symbol = "T_f",
     .unit = units::kelvin,
     .value = [](const ContactMoment& at) { return at.traction.flash; },
     .meaning = "largest rise of the surfaces if both were equally warm and took all heat of sliding",
     .needs = Needs::friction},
    {.name = "surface_temperature_pinion",
     .symbol = "T_1",
     .unit = units::kelvin,
     .value = [](const ContactMoment& at) { return at.traction.surface_pinion; },
     .meaning = "largest temperature of the pinion's flank",
     .needs = Needs::heat,
     .reduced = {{{"surface_temperature_pinion_max", Reduction::largest, units::kelvin,
                   "largest temperature of the pinion's flank", Shown::everywhere}}}},
    {.name = "surface_temperature_wheel",
     .symbol = "T_2",
     .unit = units::kelvin,
     .value = [](const ContactMoment& at) { return at.traction.surface_wheel; },
     .meaning = "largest temperature of the wheel's flank",
     .needs = Needs::heat,
     .reduced = {{{"surface_temperature_wheel_max", Reduction::largest, units::kelvin,
                   "largest temperature of the wheel's flank", Shown::everywhere}}}},
    {.name = "film_temperature_max",
     .symbol = "T",
     .unit = units::kelvin,
     .value = [](const ContactMoment& at) { return at.traction.film_max; },
     .meaning = "largest temperature in the film",
     .needs = Needs::heat,
     .reduced = {{{"film_temperature_max", Reduction::largest, units::kelvin, "largest temperature in the film",
                   Shown::everywhere}}}},
    {.name = "film_temperature_mean_max",
     .symbol = "T",
     .unit = units::kelvin,
     .value = [](const ContactMoment& at) { return at.traction.film_mean; },
     .meaning = "largest temperature of the film, each place's mean across it",
     .needs = Needs::heat},
    {.name = "heat_pinion",
     .unit = units::watt,
     .value = [](const ContactMoment& at) { return at.traction.heat_pinion; },
     .meaning = "heat from the film into the pinion",
     .needs = Needs::heat},
    {.name = "heat_wheel",
     .unit = units::watt,
     .value = [](const ContactMoment& at) { return at.traction.heat_wheel; },
     .meaning = "heat from the film into the wheel",
     .needs = Needs::heat},
    {.name = "heat_oil",
     .unit = units::watt,
     .value = [](const ContactMoment& at) { return at.traction.heat_oil; },
     .meaning = "heat that the oil takes away",
     .needs = Needs::heat},
    {.name = "temperatures_missed",
     .value = [](const ContactMoment& at) { return at.traction.unconverged_fraction; },
     .meaning = "part of the loaded nodes where temperatures across the film did not settle: bands of shear "
                "as narrow as the points are apart",
     .needs = Needs::heat,
     .reduced = {{{"temperatures_missed_max", Reduction::largest, units::number,
                   "largest part of a contact's loaded nodes where temperatures across the film did not settle",
                   Shown::march}}}},
    {.name = "heat_balance",
     .value = [](const ContactMoment& at) { return at.traction.energy_residual; },
     .meaning = "heat that is made in the film and goes nowhere, over all that is made",
     .needs = Needs::heat},
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

/// All of them; those that nothing was given for are zero.
ContactFigures figures_of(const ContactMoment& at);

/// What the film itself gave, out of the figures.
FilmFigures film_figures(const ContactFigures& figures);

}  // namespace gearfilm

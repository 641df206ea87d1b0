// The table of a contact's figures, one record each: a new figure is a new record (figure.hpp).
#pragma once

#include <optional>

#include "dynamics/figure.hpp"
#include "film/contact_film.hpp"
#include "mesh/mesh_model.hpp"
#include "traction/traction.hpp"

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

namespace figure {

/// A figure that is a member of FilmFigures: one contact, dimensionless.
template <double FilmFigures::*value, class... Rest>
constexpr Figure<ContactMoment> of_film(const Rest&... rest) {
  return of<ContactMoment>([](const ContactMoment& at) { return at.film.*value; }, rest...);
}

/// A figure that is a member of TractionFigures: friction and heat of one contact, in SI.
template <double TractionFigures::*value, class... Rest>
constexpr Figure<ContactMoment> of_traction(const Rest&... rest) {
  return of<ContactMoment>([](const ContactMoment& at) { return at.traction.*value; }, rest...);
}

}  // namespace figure

inline constexpr auto contact_figures = std::to_array<Figure<ContactMoment>>(
    {figure::of_film<&FilmFigures::pressure_integral>(
         "force", "w", units::newton, "force on the contact", Needs::nothing,
         Reduced{"force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on one contact over the static force", Shown::everywhere}),
     figure::of_film<&FilmFigures::largest_pressure>(
         "p_max", "p", units::pascal, "largest pressure", Needs::nothing,
         Reduced{"p_max", Reduction::largest, units::pascal, "largest pressure", Shown::everywhere}),
     figure::of_film<&FilmFigures::central_pressure>("p_central", "p", units::pascal, "pressure at x = y = 0",
                                                     Needs::film),
     figure::of_film<&FilmFigures::spike_pressure>(
         "p_spike", "p", units::pascal,
         "height of the outlet's spike, where pressure rises once more behind its fall; zero where it does not",
         Needs::film,
         Reduced{"p_spike_max", Reduction::largest, units::pascal, "largest height of the outlet's spike"}),
     figure::of_film<&FilmFigures::central_film>("h_central", "h", units::metre, "film thickness at x = y = 0",
                                                 Needs::film,
                                                 Reduced{"pitch_h_central", Reduction::at_pitch, units::metre,
                                                         "central film at the step nearest to the pitch point"},
                                                 Reduced{"entry_h_central", Reduction::at_entry, units::metre,
                                                         "central film at the first step after a contact entered"}),
     figure::of_film<&FilmFigures::smallest_film>(
         "h_min", "h", units::metre, "smallest film thickness", Needs::film,
         Reduced{"h_min", Reduction::smallest, units::metre, "smallest film thickness", Shown::everywhere},
         Reduced{"pitch_h_min", Reduction::at_pitch, units::metre,
                 "smallest film at the step nearest to the pitch point"},
         Reduced{"entry_h_min", Reduction::at_entry, units::metre,
                 "smallest film at the first step after a contact entered"}),
     figure::of<ContactMoment>(hertz_pressure_of, "p_hertz", "p_h", units::pascal,
                               "Hertz pressure under the present force, zero without force", Needs::nothing,
                               Reduced{"p_hertz_max", Reduction::largest, units::pascal,
                                       "largest Hertz pressure under the present force", Shown::everywhere}),
     figure::of<ContactMoment>(
         [](const ContactMoment& at) { return at.contact.conditions.sliding; }, "sliding_velocity", "u_1 - u_2",
         units::velocity,
         "surface velocity of the pinion less that of the wheel: negative before the pitch point, positive "
         "behind it",
         Needs::nothing,
         Reduced{"sliding_velocity_max", Reduction::largest, units::velocity,
                 "largest sliding velocity, of a contact behind the pitch point", Shown::everywhere},
         Reduced{"sliding_velocity_min", Reduction::smallest, units::velocity,
                 "smallest sliding velocity, negative where a contact is before the pitch point", Shown::everywhere}),
     figure::of<ContactMoment>(film_ratio, "lambda", "h_min/Rq", units::number,
                               "smallest film over the roughness of both flanks together", Needs::roughness,
                               Reduced{"lambda_min", Reduction::smallest, units::number,
                                       "smallest film over the roughness", Shown::everywhere}),
     figure::of_traction<&TractionFigures::sliding_force>(
         "friction_force", "F_s", units::si_newton, "force of sliding friction, with the sign of the sliding velocity",
         Needs::friction),
     figure::of_traction<&TractionFigures::rolling_force>("rolling_force", "F_r", units::si_newton,
                                                          "force of rolling friction on either flank", Needs::friction),
     figure::of_traction<&TractionFigures::coefficient>(
         "friction_coefficient", "mu", units::number, "friction_force over the force on the contact", Needs::friction),
     figure::of_traction<&TractionFigures::power_sliding>("power_sliding", "u_s F_s", units::watt,
                                                          "power lost by sliding", Needs::friction),
     figure::of_traction<&TractionFigures::power_rolling>("power_rolling", "2 u_m F_r", units::watt,
                                                          "power lost by rolling: of the oil that pressure drives",
                                                          Needs::friction),
     figure::of_traction<&TractionFigures::flash>(
         "flash_temperature", "T_f", units::kelvin,
         "largest rise of the surfaces if both were equally warm and took all heat of sliding", Needs::friction),
     figure::of_traction<&TractionFigures::surface_pinion>(
         "surface_temperature_pinion", "T_1", units::kelvin, "largest temperature of the pinion's flank", Needs::heat,
         Reduced{"surface_temperature_pinion_max", Reduction::largest, units::kelvin,
                 "largest temperature of the pinion's flank", Shown::everywhere}),
     figure::of_traction<&TractionFigures::surface_wheel>(
         "surface_temperature_wheel", "T_2", units::kelvin, "largest temperature of the wheel's flank", Needs::heat,
         Reduced{"surface_temperature_wheel_max", Reduction::largest, units::kelvin,
                 "largest temperature of the wheel's flank", Shown::everywhere}),
     figure::of_traction<&TractionFigures::film_max>("film_temperature_max", "T", units::kelvin,
                                                     "largest temperature in the film", Needs::heat,
                                                     Reduced{"film_temperature_max", Reduction::largest, units::kelvin,
                                                             "largest temperature in the film", Shown::everywhere}),
     figure::of_traction<&TractionFigures::film_mean>("film_temperature_mean_max", "T", units::kelvin,
                                                      "largest temperature of the film, each place's mean across it",
                                                      Needs::heat),
     figure::of_traction<&TractionFigures::heat_pinion>("heat_pinion", "", units::watt,
                                                        "heat from the film into the pinion", Needs::heat),
     figure::of_traction<&TractionFigures::heat_wheel>("heat_wheel", "", units::watt,
                                                       "heat from the film into the wheel", Needs::heat),
     figure::of_traction<&TractionFigures::heat_oil>("heat_oil", "", units::watt, "heat that the oil takes away",
                                                     Needs::heat),
     figure::of_traction<&TractionFigures::unconverged_fraction>(
         "temperatures_missed", "", units::number,
         "part of the loaded nodes where temperatures across the film did not settle: bands of shear "
         "as narrow as the points are apart",
         Needs::heat,
         Reduced{"temperatures_missed_max", Reduction::largest, units::number,
                 "largest part of a contact's loaded nodes where temperatures across the film did not settle",
                 Shown::march}),
     figure::of_traction<&TractionFigures::energy_residual>(
         "heat_balance", "", units::number, "heat that is made in the film and goes nowhere, over all that is made",
         Needs::heat)});

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

// The table of a contact's quantities, one record each: a new quantity is a new record (quantity.hpp).
#pragma once

#include <optional>

#include "dynamics/quantity.hpp"
#include "film/contact_film.hpp"
#include "mesh/mesh_model.hpp"
#include "traction/traction.hpp"

namespace gearfilm {

/// One contact at one time, from which its quantities are computed.
struct QuantityInputs {
  const Scales& scales;
  MeshedContact contact;
  FilmQuantities film;  ///< of a dry contact: its pressure integral and pressures only
  TractionQuantities traction{};
  std::optional<double> roughness{};       ///< of both flanks together [m]
  std::optional<WearCoefficients> wear{};  ///< of asperities
  double load_factor = 1.0;                ///< force of the tooth over that of the contact
  ContactStress stress{};                  ///< below the film
  const RatingModel* rating = nullptr;     ///< null: the pair is not rated
};

/// Which quantities there are.
AvailableModels available_models(bool lubricated, const std::optional<TractionModel>& traction,
                                 const std::optional<double>& roughness, const ContactSolids& solids,
                                 const std::optional<WearCoefficients>& wear, const std::optional<StressModel>& stress,
                                 const RatingModel* rating);
inline AvailableModels available_models(const MeshModel& mesh, bool lubricated) {
  AvailableModels given = available_models(lubricated, mesh.traction, mesh.roughness, mesh.scales.solids, mesh.wear,
                                           mesh.stress, mesh.rating.get());
  given.inertia = mesh.inertia != 0.0;
  return given;
}

/// h_min/Rq; zero without roughness.
double film_ratio(const QuantityInputs& at);
/// The central film over Rq, and that of the smooth film formula under the present force; zero without roughness, the
/// latter without force too.
double central_film_ratio(const QuantityInputs& at);
double smooth_film_ratio(const QuantityInputs& at);
/// Part of the surface on which asperities touch in the middle of the contact; zero where the law says nothing of it.
double real_area_ratio(const QuantityInputs& at);
/// Part of the force that asperities carry.
double asperity_load_share(const QuantityInputs& at);
/// Depth that a flank loses by one passage of the contact, in the row where asperities carry most [m] (archard.hpp).
double pinion_wear(const QuantityInputs& at);
double wheel_wear(const QuantityInputs& at);
/// Volume that a flank loses by time [m^3/s].
double pinion_wear_rate(const QuantityInputs& at);
double wheel_wear_rate(const QuantityInputs& at);
/// Contact and root stresses, film ratio and temperature by the ratings of rating_model.hpp, in SI; zero for pairs that
/// are not rated.
double rated_contact_stress(const QuantityInputs& at);
double rated_pinion_root(const QuantityInputs& at);
double rated_wheel_root(const QuantityInputs& at);
double rated_film_ratio(const QuantityInputs& at);
/// The warmer flank's largest temperature; without heat in the film the bodies' and the flash on it [K].
double rated_temperature(const QuantityInputs& at);
/// Largest pressure of the dry contact under the same force; zero without force.
double hertz_pressure_of(const QuantityInputs& at);

namespace quantity {

/// A quantity that is a member of FilmQuantities: one contact, dimensionless.
template <double FilmQuantities::*value, class... Rest>
constexpr Quantity<QuantityInputs> of_film(const Rest&... rest) {
  return of<QuantityInputs>([](const QuantityInputs& at) { return at.film.*value; }, rest...);
}

/// A quantity that is a member of TractionQuantities: friction and heat of one contact, in SI.
template <double TractionQuantities::*value, class... Rest>
constexpr Quantity<QuantityInputs> of_traction(const Rest&... rest) {
  return of<QuantityInputs>([](const QuantityInputs& at) { return at.traction.*value; }, rest...);
}

/// A number of the stresses in one body, in SI.
template <std::size_t body, double BodyStress::*value, class... Rest>
constexpr Quantity<QuantityInputs> of_stress(const Rest&... rest) {
  return of<QuantityInputs>([](const QuantityInputs& at) { return at.stress[body].*value; }, rest...);
}

}  // namespace quantity

inline constexpr auto contact_quantities = std::to_array<Quantity<QuantityInputs>>(
    {quantity::of_film<&FilmQuantities::pressure_integral>(
         "force", "w", units::newton, "force on the contact", RequiredModel::nothing,
         Reduced{"force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on one contact over the static force", ShownIn::everywhere}),
     quantity::of_film<&FilmQuantities::largest_pressure>(
         "p_max", "p", units::pascal, "largest pressure", RequiredModel::nothing,
         Reduced{"p_max", Reduction::largest, units::pascal, "largest pressure", ShownIn::everywhere}),
     quantity::of_film<&FilmQuantities::central_pressure>("p_central", "p", units::pascal, "pressure at x = y = 0",
                                                          RequiredModel::film),
     quantity::of_film<&FilmQuantities::spike_pressure>(
         "p_spike", "p", units::pascal,
         "height of the outlet's spike, where pressure rises once more behind its fall; zero where it does not",
         RequiredModel::film,
         Reduced{"p_spike_max", Reduction::largest, units::pascal, "largest height of the outlet's spike"}),
     quantity::of_film<&FilmQuantities::central_film>(
         "h_central", "h", units::metre, "film thickness at x = y = 0", RequiredModel::film,
         Reduced{"pitch_h_central", Reduction::at_pitch, units::metre,
                 "central film at the step nearest to the pitch point"},
         Reduced{"entry_h_central", Reduction::at_entry, units::metre,
                 "central film at the first step after a contact entered"}),
     quantity::of_film<&FilmQuantities::smallest_film>(
         "h_min", "h", units::metre, "smallest film thickness", RequiredModel::film,
         Reduced{"h_min", Reduction::smallest, units::metre, "smallest film thickness", ShownIn::everywhere},
         Reduced{"pitch_h_min", Reduction::at_pitch, units::metre,
                 "smallest film at the step nearest to the pitch point"},
         Reduced{"entry_h_min", Reduction::at_entry, units::metre,
                 "smallest film at the first step after a contact entered"}),
     quantity::of<QuantityInputs>(hertz_pressure_of, "p_hertz", "p_h", units::pascal,
                                  "Hertz pressure under the present force, zero without force", RequiredModel::nothing,
                                  Reduced{"p_hertz_max", Reduction::largest, units::pascal,
                                          "largest Hertz pressure under the present force", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(
         [](const QuantityInputs& at) { return at.contact.conditions.sliding; }, "sliding_velocity", "u_1 - u_2",
         units::velocity,
         "surface velocity of the pinion less that of the wheel: negative before the pitch point, positive "
         "behind it",
         RequiredModel::nothing,
         Reduced{"sliding_velocity_max", Reduction::largest, units::velocity,
                 "largest sliding velocity, of a contact behind the pitch point", ShownIn::everywhere},
         Reduced{"sliding_velocity_min", Reduction::smallest, units::velocity,
                 "smallest sliding velocity, negative where a contact is before the pitch point", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(film_ratio, "lambda", "h_min/Rq", units::number,
                                  "smallest film over the roughness of both flanks together", RequiredModel::roughness,
                                  Reduced{"lambda_min", Reduction::smallest, units::number,
                                          "smallest film over the roughness", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(central_film_ratio, "lambda_central", "h_c/Rq", units::number,
                                  "film at x = y = 0 over the roughness of both flanks together",
                                  RequiredModel::roughness),
     quantity::of<QuantityInputs>(smooth_film_ratio, "lambda_smooth", "", units::number,
                                  "central film of smooth flanks by formula over the roughness of both flanks "
                                  "together; zero without force",
                                  RequiredModel::roughness),
     quantity::of<QuantityInputs>(real_area_ratio, "real_area_ratio", "A_c/A", units::number,
                                  "part of the surface on which asperities touch at x = y = 0",
                                  RequiredModel::asperity_area),
     quantity::of<QuantityInputs>(
         asperity_load_share, "asperity_load_share", "L_a", units::number, "part of the force that asperities carry",
         RequiredModel::asperities,
         Reduced{"asperity_load_share_max", Reduction::largest, units::number,
                 "largest part of a contact's force that asperities carry", ShownIn::everywhere}),
     quantity::of_film<&FilmQuantities::asperity_integral>("asperity_force", "F_a", units::newton,
                                                           "force that asperities carry", RequiredModel::asperities),
     quantity::of<QuantityInputs>(pinion_wear, "wear_depth_pinion", "", units::si_metre,
                                  "wear of the pinion's flank by one passage of the contact, where it is largest",
                                  RequiredModel::wear,
                                  Reduced{"wear_depth_pinion_max", Reduction::largest, units::si_metre,
                                          "largest wear of the pinion's flank in one mesh", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(wheel_wear, "wear_depth_wheel", "", units::si_metre,
                                  "wear of the wheel's flank by one passage of the contact, where it is largest",
                                  RequiredModel::wear,
                                  Reduced{"wear_depth_wheel_max", Reduction::largest, units::si_metre,
                                          "largest wear of the wheel's flank in one mesh", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(pinion_wear_rate, "wear_rate_pinion", "", units::volume_rate,
                                  "volume that the pinion's flank loses by time", RequiredModel::wear,
                                  Reduced{"wear_rate_pinion_mean", Reduction::mean, units::volume_rate,
                                          "volume that the pinion loses by time, mean", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(wheel_wear_rate, "wear_rate_wheel", "", units::volume_rate,
                                  "volume that the wheel's flank loses by time", RequiredModel::wear,
                                  Reduced{"wear_rate_wheel_mean", Reduction::mean, units::volume_rate,
                                          "volume that the wheel loses by time, mean", ShownIn::everywhere}),
     quantity::of_film<&FilmQuantities::central_mean_gap>("mean_gap_central", "h_T", units::metre,
                                                          "mean gap of the rough surfaces at x = y = 0",
                                                          RequiredModel::asperities),
     quantity::of_film<&FilmQuantities::smallest_mean_gap>("mean_gap_min", "h_T", units::metre, "smallest mean gap",
                                                           RequiredModel::asperities),
     quantity::of_film<&FilmQuantities::largest_film_pressure>(
         "p_fluid_max", "p_f", units::pascal, "largest pressure of the oil", RequiredModel::asperities),
     quantity::of_film<&FilmQuantities::largest_asperity_pressure>(
         "p_asperity_max", "p_a", units::pascal, "largest pressure of the asperities", RequiredModel::asperities),
     quantity::of_traction<&TractionQuantities::sliding_force>(
         "friction_force", "F_s", units::si_newton, "force of sliding friction, with the sign of the sliding velocity",
         RequiredModel::friction),
     quantity::of_traction<&TractionQuantities::rolling_force>("rolling_force", "F_r", units::si_newton,
                                                               "force of rolling friction on either flank",
                                                               RequiredModel::friction),
     quantity::of_traction<&TractionQuantities::coefficient>("friction_coefficient", "mu", units::number,
                                                             "friction_force over the force on the contact",
                                                             RequiredModel::friction),
     quantity::of<QuantityInputs>(
         [](const QuantityInputs& at) { return at.traction.coefficient - at.traction.boundary_coefficient; },
         "friction_coefficient_fluid", "mu_f", units::number, "the oil's part of friction_coefficient",
         RequiredModel::boundary_friction),
     quantity::of_traction<&TractionQuantities::boundary_coefficient>(
         "friction_coefficient_boundary", "mu_b L_a", units::number, "the asperities' part of friction_coefficient",
         RequiredModel::boundary_friction),
     quantity::of_traction<&TractionQuantities::boundary_force>("friction_force_boundary", "F_b", units::si_newton,
                                                                "the asperities' part of friction_force",
                                                                RequiredModel::boundary_friction),
     quantity::of_traction<&TractionQuantities::power_boundary>("power_boundary", "u_s F_b", units::watt,
                                                                "the asperities' part of power_sliding",
                                                                RequiredModel::boundary_friction),
     quantity::of_traction<&TractionQuantities::power_sliding>("power_sliding", "u_s F_s", units::watt,
                                                               "power lost by sliding", RequiredModel::friction),
     quantity::of_traction<&TractionQuantities::power_rolling>("power_rolling", "2 u_m F_r", units::watt,
                                                               "power lost by rolling: of the oil that pressure drives",
                                                               RequiredModel::friction),
     quantity::of_traction<&TractionQuantities::flash>(
         "flash_temperature", "T_f", units::kelvin,
         "largest rise of the surfaces if both were equally warm and took all heat of sliding",
         RequiredModel::friction),
     quantity::of_traction<&TractionQuantities::surface_pinion>(
         "surface_temperature_pinion", "T_1", units::kelvin, "largest temperature of the pinion's flank",
         RequiredModel::heat,
         Reduced{"surface_temperature_pinion_max", Reduction::largest, units::kelvin,
                 "largest temperature of the pinion's flank", ShownIn::everywhere}),
     quantity::of_traction<&TractionQuantities::surface_wheel>(
         "surface_temperature_wheel", "T_2", units::kelvin, "largest temperature of the wheel's flank",
         RequiredModel::heat,
         Reduced{"surface_temperature_wheel_max", Reduction::largest, units::kelvin,
                 "largest temperature of the wheel's flank", ShownIn::everywhere}),
     quantity::of_traction<&TractionQuantities::film_max>(
         "film_temperature_max", "T", units::kelvin, "largest temperature in the film", RequiredModel::heat,
         Reduced{"film_temperature_max", Reduction::largest, units::kelvin, "largest temperature in the film",
                 ShownIn::everywhere}),
     quantity::of_traction<&TractionQuantities::film_mean>(
         "film_temperature_mean_max", "T", units::kelvin,
         "largest temperature of the film, each place's mean across it", RequiredModel::heat),
     quantity::of_traction<&TractionQuantities::heat_pinion>("heat_pinion", "", units::watt,
                                                             "heat from the film into the pinion", RequiredModel::heat),
     quantity::of_traction<&TractionQuantities::heat_wheel>("heat_wheel", "", units::watt,
                                                            "heat from the film into the wheel", RequiredModel::heat),
     quantity::of_traction<&TractionQuantities::heat_oil>("heat_oil", "", units::watt, "heat that the oil takes away",
                                                          RequiredModel::heat),
     quantity::of_traction<&TractionQuantities::unconverged_fraction>(
         "temperatures_missed", "", units::number,
         "part of the loaded nodes where temperatures across the film did not settle: bands of shear "
         "as narrow as the points are apart",
         RequiredModel::heat,
         Reduced{"temperatures_missed_max", Reduction::largest, units::number,
                 "largest part of a contact's loaded nodes where temperatures across the film did not settle",
                 ShownIn::march}),
     quantity::of_traction<&TractionQuantities::energy_residual>(
         "heat_balance", "", units::number, "heat that is made in the film and goes nowhere, over all that is made",
         RequiredModel::heat),
     quantity::of_stress<pinion_body, &BodyStress::von_mises>(
         "von_mises_max_pinion", "sigma_v", units::si_pascal,
         "largest von Mises stress below the contact, in the row that carries most; in the pinion",
         RequiredModel::stress,
         Reduced{"von_mises_max_pinion", Reduction::largest, units::si_pascal,
                 "largest von Mises stress below the contact, in the row that carries most; in the pinion",
                 ShownIn::everywhere}),
     quantity::of_stress<pinion_body, &BodyStress::von_mises_depth>("von_mises_depth_pinion", "z", units::si_metre,
                                                                    "its depth", RequiredModel::stress),
     quantity::of_stress<pinion_body, &BodyStress::shear>(
         "shear_max_pinion", "tau_1", units::si_pascal,
         "largest half difference of principal stresses there; in the pinion", RequiredModel::stress,
         Reduced{"shear_max_pinion", Reduction::largest, units::si_pascal,
                 "largest half difference of principal stresses there; in the pinion", ShownIn::everywhere}),
     quantity::of_stress<pinion_body, &BodyStress::shear_depth>("shear_depth_pinion", "z", units::si_metre, "its depth",
                                                                RequiredModel::stress),
     quantity::of_stress<pinion_body, &BodyStress::orthogonal_shear>(
         "orthogonal_shear_pinion", "tau_xz", units::si_pascal,
         "half the range of tau_xz along x, the largest over depth; in the pinion", RequiredModel::stress,
         Reduced{"orthogonal_shear_pinion", Reduction::largest, units::si_pascal,
                 "half the range of tau_xz along x, the largest over depth; in the pinion", ShownIn::everywhere}),
     quantity::of_stress<pinion_body, &BodyStress::orthogonal_shear_depth>(
         "orthogonal_shear_depth_pinion", "z", units::si_metre, "its depth", RequiredModel::stress),
     quantity::of_stress<pinion_body, &BodyStress::surface_tension>(
         "surface_tension_pinion", "sigma_I", units::si_pascal,
         "largest principal stress at the pinion's surface; zero where none is tensile", RequiredModel::stress,
         Reduced{"surface_tension_pinion", Reduction::largest, units::si_pascal,
                 "largest principal stress at the pinion's surface; zero where none is tensile", ShownIn::everywhere}),
     quantity::of_stress<wheel_body, &BodyStress::von_mises>(
         "von_mises_max_wheel", "sigma_v", units::si_pascal,
         "largest von Mises stress below the contact, in the row that carries most; in the wheel",
         RequiredModel::stress,
         Reduced{"von_mises_max_wheel", Reduction::largest, units::si_pascal,
                 "largest von Mises stress below the contact, in the row that carries most; in the wheel",
                 ShownIn::everywhere}),
     quantity::of_stress<wheel_body, &BodyStress::von_mises_depth>("von_mises_depth_wheel", "z", units::si_metre,
                                                                   "its depth", RequiredModel::stress),
     quantity::of_stress<wheel_body, &BodyStress::shear>(
         "shear_max_wheel", "tau_1", units::si_pascal,
         "largest half difference of principal stresses there; in the wheel", RequiredModel::stress,
         Reduced{"shear_max_wheel", Reduction::largest, units::si_pascal,
                 "largest half difference of principal stresses there; in the wheel", ShownIn::everywhere}),
     quantity::of_stress<wheel_body, &BodyStress::shear_depth>("shear_depth_wheel", "z", units::si_metre, "its depth",
                                                               RequiredModel::stress),
     quantity::of_stress<wheel_body, &BodyStress::orthogonal_shear>(
         "orthogonal_shear_wheel", "tau_xz", units::si_pascal,
         "half the range of tau_xz along x, the largest over depth; in the wheel", RequiredModel::stress,
         Reduced{"orthogonal_shear_wheel", Reduction::largest, units::si_pascal,
                 "half the range of tau_xz along x, the largest over depth; in the wheel", ShownIn::everywhere}),
     quantity::of_stress<wheel_body, &BodyStress::orthogonal_shear_depth>(
         "orthogonal_shear_depth_wheel", "z", units::si_metre, "its depth", RequiredModel::stress),
     quantity::of_stress<wheel_body, &BodyStress::surface_tension>(
         "surface_tension_wheel", "sigma_I", units::si_pascal,
         "largest principal stress at the wheel's surface; zero where none is tensile", RequiredModel::stress,
         Reduced{"surface_tension_wheel", Reduction::largest, units::si_pascal,
                 "largest principal stress at the wheel's surface; zero where none is tensile", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(
         rated_contact_stress, "sigma_H", "sigma_H", units::si_pascal,
         "line contact's pressure under the force, over the whole face", RequiredModel::rating,
         Reduced{"sigma_H_max", Reduction::largest, units::si_pascal,
                 "largest pressure of a line contact under the force, over the whole face", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(rated_pinion_root, "sigma_F_pinion", "sigma_F1", units::si_pascal,
                                  "stress at the root of the pinion's tooth, by this contact",
                                  RequiredModel::rated_root,
                                  Reduced{"sigma_F_max_pinion", Reduction::largest, units::si_pascal,
                                          "largest stress at the root of the pinion's teeth", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(rated_wheel_root, "sigma_F_wheel", "sigma_F2", units::si_pascal,
                                  "stress at the root of the wheel's tooth, by this contact", RequiredModel::rated_root,
                                  Reduced{"sigma_F_max_wheel", Reduction::largest, units::si_pascal,
                                          "largest stress at the root of the wheel's teeth", ShownIn::everywhere}),
     quantity::of<QuantityInputs>(rated_film_ratio, "lambda_GF", "lambda_GF", units::number,
                                  "film after ISO/TS 6336-22 over Ra; zero without force", RequiredModel::rated_film),
     quantity::of<QuantityInputs>(
         rated_temperature, "contact_temperature", "T_B", units::kelvin,
         "largest temperature of either flank; without heat in the film the bodies' with the flash on it",
         RequiredModel::rated_heat,
         Reduced{"contact_temperature_max", Reduction::largest, units::kelvin,
                 "largest temperature of either flank, for scuffing", ShownIn::everywhere})});

/// A quantity by its name: one that does not exist ends the compilation.
struct ContactQuantityName {
  consteval ContactQuantityName(const char* name) : place(place_in(contact_quantities, name)) {}
  std::size_t place;
};

/// Values of all quantities of one contact, dimensionless, in the order of the table.
struct ContactQuantities {
  std::array<double, contact_quantities.size()> values{};

  double& operator[](ContactQuantityName name) { return values[name.place]; }
  double operator[](ContactQuantityName name) const { return values[name.place]; }
};

/// All of them; those that nothing was given for are zero.
ContactQuantities quantities_of(const QuantityInputs& at);

/// What the film itself gave, out of the quantities.
FilmQuantities film_quantities(const ContactQuantities& quantities);

}  // namespace gearfilm

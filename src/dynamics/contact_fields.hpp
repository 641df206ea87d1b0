// What a contact carries in time: fields under their names.
//
// Code that keeps, restores, compares or shows the state of a contact does so for every name there is: a new field is
// one name here. It stays as it is over a time step or a jump unless somebody advances it.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dynamics/quantity.hpp"
#include "traction/film_heat.hpp"

namespace gearfilm {

/// Compact fields by their names: nx*y_count dimensionless values of this process each.
using ContactFields = std::map<std::string, std::vector<double>, std::less<>>;

/// What is to be known of a name.
struct ContactField {
  std::string_view name;
  std::string_view dataset;   ///< its name in results.h5; empty: not written
  Unit unit = units::number;  ///< there
  std::string_view meaning{};
  bool compared = true;  ///< counts in the defect of a periodic state, and in disturbances of it
  double smallest = -std::numeric_limits<double>::infinity();  ///< that a disturbed state may have
  bool loaded_only =
      false;  ///< compared where there is pressure: in the cavitated film it may differ and means nothing
};

namespace field {
inline constexpr ContactField pressure{
    .name = "pressure", .dataset = "P", .unit = units::pascal, .meaning = "pressure", .smallest = 0.0};
/// Film thickness: of snapshots only, since it follows from pressure and motion.
inline constexpr ContactField thickness{
    .name = "film", .dataset = "H", .unit = units::metre, .meaning = "film thickness"};
/// What oil and asperities carry between rough surfaces, and their mean gap: of snapshots, no part of a state.
inline constexpr ContactField film_pressure{.name = "film_pressure",
                                            .dataset = "p_fluid",
                                            .unit = units::pascal,
                                            .meaning = "pressure of the oil; between rough surfaces"};
inline constexpr ContactField asperity_pressure{.name = "asperity_pressure",
                                                .dataset = "p_asperity",
                                                .unit = units::pascal,
                                                .meaning = "pressure of the asperities; between rough surfaces"};
inline constexpr ContactField mean_gap{.name = "mean_gap",
                                       .dataset = "gap_mean",
                                       .unit = units::metre,
                                       .meaning = "mean gap, which the oil fills; between rough surfaces"};
/// d(rho H)/dT, at which a film squeezes: no state of its own, and nothing to look at.
inline constexpr ContactField rate{.name = "rate", .dataset = "", .compared = false};

/// beta (T - T_0) at a point across the film: the name begins so.
inline constexpr std::string_view heat = "heat_";
/// A field and where it is among those of its owner.
template <class Owner>
struct Of {
  ContactField field;
  std::vector<double> Owner::*values;
};

/// What heat and shear make of the flow: nothing to compare, since temperatures and pressures are.
constexpr Of<FlowFactors> of_flow_factors(std::string_view name, std::vector<double> FlowFactors::*values) {
  return {{.name = name, .dataset = "", .compared = false}, values};
}

inline constexpr auto correction = std::to_array<Of<FlowFactors>>(
    {of_flow_factors("thinning", &FlowFactors::log_poiseuille),
     of_flow_factors("wedge", &FlowFactors::entrainment_excess),
     of_flow_factors("density_factor", &FlowFactors::density_ratio),
     of_flow_factors("shear", &FlowFactors::shear_index), of_flow_factors("across", &FlowFactors::cross_flow)});

/// What follows from a film for friction and heat: of results only.
constexpr Of<TractionFields> of_traction(std::string_view name, Unit unit, std::vector<double> TractionFields::*values,
                                         std::string_view meaning) {
  return {{.name = name, .dataset = name, .unit = unit, .meaning = meaning, .compared = false}, values};
}

inline constexpr auto traction = std::to_array<Of<TractionFields>>(
    {of_traction("shear_stress", units::si_pascal, &TractionFields::shear_stress,
                 "shear stress in the middle of the film, of the sign of the sliding velocity"),
     of_traction("temperature_pinion", units::kelvin, &TractionFields::temperature_pinion,
                 "temperature of the pinion's flank"),
     of_traction("temperature_wheel", units::kelvin, &TractionFields::temperature_wheel,
                 "temperature of the wheel's flank"),
     of_traction("temperature_mean", units::kelvin, &TractionFields::temperature_mean,
                 "temperature of the film, mean across it"),
     of_traction("temperature_mid", units::kelvin, &TractionFields::temperature_mid,
                 "temperature in the middle of the film"),
     of_traction("temperature_max", units::kelvin, &TractionFields::temperature_max,
                 "largest temperature across the film"),
     of_traction("heat_flux_pinion", units::heat_flux, &TractionFields::heat_flux_pinion,
                 "heat from the film into the pinion"),
     of_traction("heat_flux_wheel", units::heat_flux, &TractionFields::heat_flux_wheel,
                 "heat from the film into the wheel"),
     of_traction("log_flow_factor", units::number, &TractionFields::log_flow_factor,
                 "logarithm of the flow over that of the same film without heat, of a film that feels its heat")});

/// Below the film where it is largest in the row that carries most (`von_mises_depth_...`): of results only.
constexpr ContactField of_stress(std::string_view name, std::string_view meaning) {
  return {.name = name, .dataset = name, .unit = units::si_pascal, .meaning = meaning, .compared = false};
}

inline constexpr auto von_mises =
    std::to_array<ContactField>({of_stress("von_mises_pinion",
                                           "von Mises stress in the pinion at the depth where it "
                                           "is largest in its worst row; with `stress.model: field`"),
                                 of_stress("von_mises_wheel", "the same in the wheel")});

inline constexpr auto all = std::to_array<ContactField>(
    {pressure, thickness, film_pressure, asperity_pressure, mean_gap, rate, von_mises[0], von_mises[1]});
}  // namespace field

/// A name that says nothing else of itself is a pure number, written under its name and compared.
constexpr ContactField field_named(std::string_view name) {
  for (const ContactField& known : field::all) {
    if (known.name == name) return known;
  }
  for (const auto& known : field::correction) {
    if (known.field.name == name) return known.field;
  }
  for (const auto& known : field::traction) {
    if (known.field.name == name) return known.field;
  }
  if (name.starts_with(field::heat)) return {.name = name, .dataset = "", .loaded_only = true};
  return {.name = name, .dataset = name};
}

/// A field that must be there; throws std::out_of_range.
inline const std::vector<double>& values_of(const ContactFields& fields, const ContactField& field) {
  return fields.at(std::string(field.name));
}
inline std::vector<double>& values_of(ContactFields& fields, const ContactField& field) {
  return fields.at(std::string(field.name));
}

}  // namespace gearfilm

// What a contact carries in time: fields under their names.
//
// Whoever keeps, restores, compares or shows the state of a contact does so for every name there is: a new field is one
// name here. It stays as it is over a time step or a jump unless somebody advances it.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gearfilm/dynamics/figure.hpp"

namespace gearfilm {

/// Compact fields by their names: nx*y_count dimensionless values of this process each.
using ContactFields = std::map<std::string, std::vector<double>, std::less<>>;

/// What is to be known of a name.
struct ContactField {
  std::string_view name;
  std::string_view dataset;   ///< its name in results.h5; empty: not written
  Unit unit = units::number;  ///< there
  bool compared = true;       ///< counts in the defect of a periodic state, and in disturbances of it
  double smallest = -std::numeric_limits<double>::infinity();  ///< that a disturbed state may have
};

namespace field {
inline constexpr ContactField pressure{.name = "pressure", .dataset = "P", .unit = units::pascal, .smallest = 0.0};
/// Film thickness: of snapshots only, since it follows from pressure and motion.
inline constexpr ContactField thickness{.name = "film", .dataset = "H", .unit = units::metre};
/// d(rho H)/dT, at which a film squeezes: no state of its own, and nothing to look at.
inline constexpr ContactField rate{.name = "rate", .dataset = "", .compared = false};
inline constexpr auto all = std::to_array<ContactField>({pressure, thickness, rate});
}  // namespace field

/// A name that says nothing else of itself is a pure number, written under its name and compared.
constexpr ContactField field_named(std::string_view name) {
  for (const ContactField& known : field::all) {
    if (known.name == name) return known;
  }
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

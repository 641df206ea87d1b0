// What distinguishes a contact at one moment from the reference contact of the Scales, and its dry counterpart.
#pragma once

#include "gearfilm/contact/scales.hpp"

namespace gearfilm {

struct ContactConditions {
  double relative_radius = 1.0;  ///< Rbar = R_x/R_x* [-]
  double entrainment = 1.0;      ///< U = u_m/u_m* [-]
  double gap_offset = 0.0;       ///< added to H: tip relief, pitch error [-]

  bool operator==(const ContactConditions&) const = default;
};

/// The reference contact's solids with the radius R_x of the moment.
ContactSolids solids_of(const Scales& scales, const ContactConditions& conditions);

/// Pressure integral of the dry contact that one unit of H presses together, without its offset [-].
double force_at_unit_approach(const Scales& scales, const ContactConditions& conditions);

/// Hertz contact of the given radius under the pressure integral F (in units of F*: the reference load) [SI].
HertzContact dry_contact(const Scales& scales, const ContactConditions& conditions, double pressure_integral);

}  // namespace gearfilm

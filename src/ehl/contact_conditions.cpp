#include "gearfilm/ehl/contact_conditions.hpp"

namespace gearfilm {

ContactSolids solids_of(const Scales& scales, const ContactConditions& conditions) {
  ContactSolids solids = scales.solids;
  solids.radius_x *= conditions.relative_radius;
  return solids;
}

HertzContact dry_contact(const Scales& scales, const ContactConditions& conditions, double pressure_integral) {
  return hertz_contact(solids_of(scales, conditions), scales.force(pressure_integral));
}

double force_at_unit_approach(const Scales& scales, const ContactConditions& conditions) {
  return hertz_load(solids_of(scales, conditions), scales.thickness) / scales.operation.load * scales.static_force;
}

}  // namespace gearfilm

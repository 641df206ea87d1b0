#include "gearfilm/ehl/contact_conditions.hpp"

namespace gearfilm {

HertzContact dry_contact(const Scales& scales, const ContactConditions& conditions, double pressure_integral) {
  ContactSolids solids = scales.solids;
  solids.radius_x *= conditions.radius_ratio;
  return hertz_contact(solids, scales.force(pressure_integral));
}

}  // namespace gearfilm

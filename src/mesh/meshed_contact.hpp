// One tooth contact at one place on the line of action, relative to the reference contact.
//
//   Rbar = R_x(xi)/R_x* ,   U = u_m(xi)/u_m* ,   S = (u_1 - u_2)(xi)/u_m*          line_of_action.hpp, scales.hpp
#pragma once

#include "film/contact_conditions.hpp"
#include "gear/line_of_action.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

struct MeshedContact {
  double position = 0.0;  ///< xi [m]
  ContactConditions conditions;
};

/// Velocities of both surfaces in SI.
SurfaceVelocities velocities_of(const Scales& scales, const MeshedContact& contact);

/// Beyond either end of the path of contact the conditions are those of the end.
MeshedContact meshed_contact(const LineOfAction& line, const Scales& scales, double pinion_speed, double xi);

}  // namespace gearfilm

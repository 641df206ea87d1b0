// The force of reverse flanks, which touch when the gears have separated by the backlash: dry Hertz contacts.
//
//   q F_b^(2/3) + c F_b = H_0 - (jbar + e_b) ,   jbar = j_n R_x*/a^2 ,   all at xi_b (teeth.hpp)
// It pushes the gears together: I_n dV_0/dT = sum F - sum F_b - F*. Films between reverse flanks are not modelled, nor
// do back and front teeth bend each other.
#pragma once

#include "mesh/mesh_model.hpp"

namespace gearfilm {

struct ReverseForce {
  double value = 0.0;  ///< sum of F_b [-]
  double slope = 0.0;  ///< its derivative by H_0 [-]
};

/// None without a backlash, or where one contact is followed by itself.
ReverseForce reverse_flank_force(const MeshModel& mesh, double H0, double T);
/// Of a motion; in a drive train of what the reverse flanks have approached in it (mesh_train.hpp), in the place of
/// H_0.
ReverseForce reverse_flank_force(const MeshModel& mesh, const Motion& motion, double T);

}  // namespace gearfilm

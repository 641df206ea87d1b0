// Tooth stiffness by ISO 6336-1, method B, for comparison: line contact and standard bodies included. The constants of
// q' are those of steel; other materials count by their modulus, E = 2 E_1 E_2/(E_1 + E_2) over 206 GPa.
#pragma once

#include "gear/tooth_profile.hpp"

namespace gearfilm {

struct IsoStiffness {
  double single = 0.0;  ///< c' of one pair of teeth, times the face width [N/m]
  double mesh = 0.0;    ///< c_gamma, the mean over the mesh, times the face width [N/m]
};

/// c' = 0.8/q' E/E_steel, c_gamma = c' (0.75 eps + 0.25), q' by numbers of teeth and profile shifts.
IsoStiffness iso_stiffness(const SpurGearPair& pair, double contact_ratio);

}  // namespace gearfilm

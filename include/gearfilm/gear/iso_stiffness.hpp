// Tooth stiffness by ISO 6336-1, method B, for comparison: of steel gears, line contact and standard bodies included.
#pragma once

#include "gearfilm/gear/tooth_profile.hpp"

namespace gearfilm {

struct IsoStiffness {
  double single = 0.0;  ///< c' of one pair of teeth, times the face width [N/m]
  double mesh = 0.0;    ///< c_gamma, the mean over the mesh, times the face width [N/m]
};

/// c' = 0.8/q', c_gamma = c' (0.75 eps + 0.25), q' by numbers of teeth and profile shifts.
IsoStiffness iso_stiffness(const SpurGearPair& pair, double contact_ratio);

}  // namespace gearfilm

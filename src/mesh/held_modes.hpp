// The motion of a drive train whose slowest modes are held where the constant torques put them.
//
//   y = W z ,     v_i^T M W = 0 of every mode i that is held,     y_1 = z_1
//   M_z = W^T M W ,  K_z = W^T K W ,  C_z = W^T C W
// The mesh, f_m, moves a mode of frequency f by s (f/f_m)^2 of what it moves the flanks, s its share of the mesh: what
// is held is below s/40000 of the motion. A search for periodic motions that carried the mode would multiply the errors
// of films by f_m/(2 pi f), above 30, since the mode all but comes back from wherever it is pushed.
#pragma once

#include <vector>

#include "mesh/mesh_train.hpp"

namespace gearfilm {

struct HeldModes {
  std::shared_ptr<const MeshTrain> train;  ///< without them
  std::vector<double> frequencies;         ///< of those that are held [Hz]
};

/// Holds the modes below f_m/200 in which the mesh has a share below 0.001; none where a torque fluctuates. f_m [Hz].
HeldModes hold_slow_modes(const std::shared_ptr<const MeshTrain>& train, double mesh_frequency);

}  // namespace gearfilm

// The motion of a drive train without its rotation as a whole.
//
//   q = Z y + phi_0 r ,   K phi_0 = C phi_0 = B phi_0 = 0 ,   Z^T M phi_0 = 0 ,   R Z = 1 ,   y = R q
// In y the equations are those of Z^T M Z, Z^T C Z, Z^T K Z and B Z; r turns by itself, at the mean speed. The
// relative coordinates R q, all of them lengths, begin with h = B q and go on with ways of the elements: twists of
// shafts, displacements in bearings. Of two gears that only turn y = h and Z^T M Z is their equivalent mass. Where a
// speed is imposed or the ground holds a rotation, nothing turns freely: phi_0 is absent and Z square.
#pragma once

#include "train/train.hpp"

namespace gearfilm {

struct RelativeMotion {
  Eigen::MatrixXd coordinates;  ///< R
  Eigen::MatrixXd motions;      ///< Z
  Eigen::VectorXd rigid{};      ///< phi_0, its largest entry as a length 1; empty: nothing turns freely

  /// The projection of M, C or K.
  Eigen::MatrixXd projected(const Eigen::MatrixXd& matrix) const { return motions.transpose() * matrix * motions; }
};

/// Throws InputError where more than one rotation of the whole is free, naming the nodes that hang on nothing, and
/// where a contact cannot part.
RelativeMotion relative_motion(const Train& train);

}  // namespace gearfilm

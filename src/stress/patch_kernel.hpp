// Stresses in a half-space z > 0 under a load that is uniform on a rectangle of its surface.
//
// The load is the traction on the body: p presses into it, q_x pushes along x, so that at z = 0 sigma_zz = -p and
// sigma_xz = -q_x on the rectangle. With (x, y) from the place to a corner the stress is the sum over the corners
//   sigma = (1/2 pi) sum (+-)(+-) F(x, y, z)
// of Boussinesq's and Cerruti's point solutions, integrated (Love 1929, doi 10.1098/rsta.1929.0009, for p). With
// R^2 = x^2 + y^2 + z^2, Rx = R + x, Ry = R + y, Rz = R + z, A = atan(x y/(z R)),
// X2 = atan(x y (R - z)/(x^2 R + y^2 z)) and Y2 = atan(x y (R - z)/(y^2 R + x^2 z)):
//
//   load p                                       load q_x
//   xx  -X2 - 2 nu Y2 - z x/(R Ry)               2 ln Ry - 2 y/Rz + z [y/(R Rz) + z/(R Ry)] + 2 (1 + nu) y/Rz
//   yy  -Y2 - 2 nu X2 - z y/(R Rx)               2 nu ln Ry - 2 nu y/Rz - z y/(R Rz)
//   zz  -A + z [x/(R Ry) + y/(R Rx)]             -z^2/(R Ry)
//   yz  -z^2/(R Rx)                              -z/R
//   xz  -z^2/(R Ry)                              -A - z x/(R Ry)
//   xy  -(1 - 2 nu) ln Rz - z/R                  ln Rx - x/Rz + (1 - 2 nu) x/Rz - z x/(R Rz)
// A load q_y is q_x with x and y exchanged. Verified against point solutions and Hertz contacts (stress_test.cpp).
#pragma once

#include "grid/row_axis.hpp"
#include "stress/equivalent_stress.hpp"

namespace gearfilm {

enum class SurfaceLoad { pressure, shear_x, shear_y };

/// F/(2 pi) of a corner at (x, y) from the place, at the depth z >= 0; nu: Poisson's ratio. Not below an edge at z = 0.
Stress patch_corner(SurfaceLoad load, double x, double y, double z, double nu);

/// Stress at the depth z beneath a place, x away from the middle line of a cell h_x wide that lies in a strip of y
/// relative to the place, under unit load.
Stress patch_stress(SurfaceLoad load, double x, double h_x, const Strip& strip, double z, double nu);

}  // namespace gearfilm

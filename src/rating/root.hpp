// Stress at a tooth's root, after ISO 6336-3: tangents at 30 degrees to the centre line. Spur gears with a full rim.
//
// Of a rack with the addendum h_fP m and the tip radius rho_fP m, z teeth shifted by x m, lengths over m:
//   E = pi/4 - h_fP tan a - (1 - sin a) rho_fP/cos a ,  G = rho_fP - h_fP + x ,  H = (2/z)(pi/2 - E) - pi/3
//   th = (2 G/z) tan th - H ,   s_F = z sin(pi/3 - th) + sqrt 3 (G/cos th - rho_fP)
//   rho_F = rho_fP + 2 G^2/[cos th (z cos^2 th - 2 G)]
// A force at the radius r_e, a_e = acos(r_b/r_e):
//   g_e = (pi/2 + 2 x tan a)/z + inv a - inv a_e ,  a_F = a_e - g_e
//   h_F = [ (cos g_e - sin g_e tan a_F) 2 r_e/m - z cos(pi/3 - th) - G/cos th + rho_fP ]/2
//   Y_F = 6 h_F cos a_F/(s_F^2 cos a) ,  Y_S = (1.2 + 0.13 L) q_s^(1/(1.21 + 2.3/L)) ,  L = s_F/h_F , q_s = s_F/(2
//   rho_F) sigma_F = F_t/(b m) Y_F Y_S ,  S_F = sigma_FE Y_NT/sigma_F
// Reproduced: the FZG pair C14 as a public program rates it (damage_test.cpp). Left out: Y_delta and Y_R (within 5 %),
// thin rims, grinding notches.
#pragma once

#include "gear/gear_pair.hpp"

namespace gearfilm {

/// How a tooth is loaded at a place: Y_F and Y_S.
struct RootFactors {
  double form = 0.0;
  double stress_correction = 0.0;
};

class ToothRoot {
public:
  /// The root of a gear with the profile shift x, cut by the rack that its root circle and tool say. Throws
  /// InputError where such a rack has no tangent at 30 degrees.
  ToothRoot(const SpurGear& gear, const SpurGearPair& pair, double profile_shift);

  /// Factors for a force on the flank where its radius of curvature is rho [m].
  RootFactors factors(double rho) const;
  /// sigma_F [Pa] of a force along the line of action [N] there.
  double stress(double force, double rho) const;
  double root_thickness() const { return thickness_; }  ///< s_F over the module
  double fillet_radius() const { return fillet_; }      ///< rho_F over the module

private:
  double teeth_, shift_, module_, face_width_, rack_angle_, base_radius_;
  double rack_tip_ = 0.0;  ///< rho_fP
  double depth_ = 0.0;     ///< G
  double angle_ = 0.0;     ///< th
  double thickness_ = 0.0, fillet_ = 0.0;
};

/// Y_NT of case-hardened steel after load cycles.
double root_life_factor(double cycles);

}  // namespace gearfilm

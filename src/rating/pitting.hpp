// Contact stress and the safety against pitting, after ISO 6336-2. Spur gears.
//
//   sigma_H0 = Z_H Z_E Z_eps ( F_t/(d_1 b) (u + 1)/u )^(1/2) ,
//   Z_E = ( pi sum (1 - nu^2)/E )^(-1/2) ,  Z_H = ( 2 cos a_w/(cos^2 a sin a_w) )^(1/2) ,  Z_eps = ( (4 - eps)/3
//   )^(1/2) Z_B = max(1, M_1) ,  M_1 = tan a_w / ( [(d_a1^2/d_b1^2 - 1)^(1/2) - 2 pi/z_1]
//                                          [(d_a2^2/d_b2^2 - 1)^(1/2) - (eps - 1) 2 pi/z_2] )^(1/2) ; Z_D by exchange
//   S_H = sigma_Hlim Z_NT Z_L Z_v Z_R/sigma_H ,   case-hardened steel
// sigma_H0/Z_eps is the line contact's Hertz pressure at the pitch point, Z_B what it grows by at the inner point of
// single contact. Z factors: reproduced from example 1 of ISO/TR 6336-30 as quoted in public code (damage_test.cpp).
// Left out: Z_W, other steels, and the load factors K of ISO 6336-1, in whose place forces are computed.
#pragma once

#include "gear/gear_pair.hpp"

namespace gearfilm {

/// Nominal stress of a pair and its factors.
struct NominalContactStress {
  double zone_factor = 0.0;        ///< Z_H
  double elasticity_factor = 0.0;  ///< Z_E [Pa^0.5]
  double ratio_factor = 0.0;       ///< Z_eps
  double pinion_factor = 1.0;      ///< Z_B
  double wheel_factor = 1.0;       ///< Z_D
  double stress = 0.0;             ///< sigma_H0 [Pa]
};

/// Under a torque at the pinion [N m].
NominalContactStress nominal_contact_stress(const SpurGearPair& pair, double pinion_torque);

/// Z_E of two materials [Pa^0.5].
double elasticity_factor(const SpurGear& pinion, const SpurGear& wheel);

/// Z_NT of case-hardened steel after load cycles.
double contact_life_factor(double cycles);
/// Z_L; viscosity at 40 degrees [m^2/s].
double lubricant_factor(double viscosity, double limit);
/// Z_v; pitch line velocity [m/s].
double velocity_factor(double velocity, double limit);
/// Z_R; mean roughness depth R_z of both flanks [m]; reduced radius at the pitch point [m].
double roughness_factor(double roughness_depth, double reduced_radius, double limit);

}  // namespace gearfilm

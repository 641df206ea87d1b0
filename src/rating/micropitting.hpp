// Film ratio of micropitting, after ISO/TS 6336-22.
//
//   h_Y = 1600 rho G^0.6 U^0.7 W^-0.13 S^0.22   (lengths in mm, h in um; 1.6 in SI)
//   G = alpha E_r , U = eta (u_1 + u_2)/(2 E_r rho) , W = w/(E_r rho) = 2 pi (p/E_r)^2 , E_r = 2/sum((1 - nu^2)/E)
//   lambda_GF = h_Y/Ra ,  Ra = (Ra_1 + Ra_2)/2 ,  S_lambda = min lambda_GF/lambda_GFP
// The form is that of a published passage (Jbily et al. 2024, Procedia Structural Integrity 57, 199); its symbols are
// second-hand. S, the change of alpha eta by local heat, is 1 here. lambda_GFP is an input from a test of the oil; no
// document recommends a safety.
#pragma once

namespace gearfilm {

struct MicropittingContact {
  double reduced_radius = 0.0;        ///< rho [m]
  double entrainment_velocity = 0.0;  ///< (u_1 + u_2)/2 [m/s]
  double line_load = 0.0;             ///< w [N/m]
};

/// The oil at the temperature of the bodies, and E_r.
struct MicropittingOil {
  double viscosity = 0.0;           ///< eta [Pa s]
  double pressure_viscosity = 0.0;  ///< alpha [1/Pa]
  double reduced_modulus = 0.0;     ///< E_r [Pa]
};

/// h_Y [m].
double micropitting_film(const MicropittingContact& contact, const MicropittingOil& oil);

}  // namespace gearfilm

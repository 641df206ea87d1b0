// Amplitude of waves on a surface within a lubricated line contact over that outside of it; their crests lie across the
// rolling, and they travel with the entrainment.
//
//   A_d/A_i = 1/(1 + 0.125 nabla + 0.04 nabla^2) ,   nabla = (Lambda/a) M^(3/4)/L^(1/2)
//   M = w'/(E' R_x) (2 U)^(-1/2) = 2 pi (p_h/E')^2 (2 U)^(-1/2) ,  L = alpha_B E' (2 U)^(1/4) ,  U = eta_0 u_m/(E' R_x)
// Source: that the ratio follows nabla alone: Venner, Couhier, Lubrecht and Greenwood 1997 (Tribology Series 32,
// 103-112), of which the abstract was read. Assumption: the two constants, from memory; computed amplitudes lie within
// 0.1 of it (docs/guide/mixed-lubrication.md).
#pragma once

#include "contact/moes.hpp"

namespace gearfilm {

/// dry: half-width and pressure of the contact; wavelength [m].
double remaining_amplitude(const ContactSolids& solids, const Lubricant& oil, const HertzContact& dry,
                           double entrainment_velocity, double wavelength);

}  // namespace gearfilm

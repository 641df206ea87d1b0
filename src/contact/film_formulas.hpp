// Film thickness formulas of stationary elastohydrodynamic point contacts, for comparison with computed films.
//
// Hamrock and Dowson 1977 (doi 10.1115/1.3453074), U = eta_0 u_m/(E' R_x), W = w/(E' R_x^2), G = alpha_B E',
// k = 1.03 (R_y/R_x)^0.64:
//   h_c/R_x   = 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
//   h_min/R_x = 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
// Nijenbanning, Venner and Moes 1994 (doi 10.1016/0043-1648(94)90150-3), central film, incompressible, in M, L, D
// with H = (h/R_x)(2U)^(-1/2).
#pragma once

#include "contact/moes.hpp"

namespace gearfilm {

double hamrock_dowson_central(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);
double hamrock_dowson_minimum(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

/// Central film [m]. The formula is for an incompressible fluid: a compressible one is divided by rho(p_h)/rho_0 here.
double nijenbanning_venner_moes_central(const ContactSolids& solids, const Lubricant& oil,
                                        const ContactOperation& operation);

}  // namespace gearfilm

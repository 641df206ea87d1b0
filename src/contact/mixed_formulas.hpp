// Films and load shares between rough surfaces by the formulas of Masjedi and Khonsari, for comparison.
//
// W = w/(E' R_x^2), of a line w'/(E' R_x); U = eta_0 u_m/(E' R_x), G = alpha_B E', s = sigma/R_x, V = H/E', k = b/a.
// Line (2012, doi 10.1115/1.4005514):
//   h_min/R_x = 1.652 W^-0.077 U^0.716 G^0.695 (1 + 0.026 s^1.120 V^0.185 W^-0.312 U^-0.809 G^-0.977)
//   h_c/R_x   = 2.691 W^-0.135 U^0.705 G^0.556 (1 + 0.2 s^1.222 V^0.223 W^-0.229 U^-0.748 G^-0.842)
//   100 L_a   = 0.005 W^-0.408 U^-0.088 G^0.103 ln(1 + 4470 s^6.015 V^1.168 W^0.485 U^-3.741 G^-2.898)
// Point (2015, doi 10.1016/j.triboint.2014.09.010):
//   h_c/R_x   = 3.672 W^(-0.045 k^0.18) U^(0.663 k^0.025) G^(0.502 k^0.064) (1 - 0.573 e^(-0.74 k))
//               (1 + 0.025 s^1.248 V^0.119 W^-0.133 U^-0.884 G^-0.977 k^0.081)
//   h_min/R_x = 1.637 W^(-0.09 k^-0.15) U^(0.711 k^-0.023) G^(0.65 k^-0.045) (1 - 0.974 e^(-0.676 k))
//               (1 + 0.141 s^1.073 V^0.149 W^-0.044 U^-0.828 G^-0.954 k^-0.395)
//   100 L_a   = 10 W^-0.083 U^0.143 G^0.314 ln(1 + s^4.689 V^0.509 W^-0.501 U^-2.9 G^-2.87)
// Assumption: of both papers only the abstracts were read, the constants are from memory; films by them agree with
// computed ones at k = 1, and a power of k that belongs to the last formula is left out. L_a is cut off at 1.
#pragma once

#include "contact/moes.hpp"

namespace gearfilm {

struct MixedPrediction {
  double central_film = 0.0;   ///< [m]
  double smallest_film = 0.0;  ///< [m]
  double load_share = 0.0;     ///< L_a
  /// Slow contacts are beyond what the formulas were fitted to (U < 1e-12; an assumption), and so are those whose L_a
  /// would be above 1.
  bool valid = false;
};

/// Films and load share of an operation by the formulas; the roughness of the solids must be given.
MixedPrediction masjedi_khonsari(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm

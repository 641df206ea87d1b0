// Natural frequency of the dry gear pair, linearised at the pitch point: the formulas.
//
//   k_el = 3 w*/(2 h_0n) ,   f_n = sqrt(k_el/m_ge)/(2 pi)        (28) of doi 10.1016/j.triboint.2013.01.017
#pragma once

#include <cmath>
#include <numbers>

namespace gearfilm {

/// f_n for a stiffness and the equivalent mass: [Hz] of SI.
inline double natural_frequency(double stiffness, double equivalent_mass) {
  return std::sqrt(stiffness / equivalent_mass) / (2.0 * std::numbers::pi);
}

}  // namespace gearfilm

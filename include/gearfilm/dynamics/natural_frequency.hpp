// Natural frequency of the dry gear pair, linearised at the pitch point.
//
//   k_el = 3 w*/(2 h_0n) ,   f_n = sqrt(k_el/m_ge)/(2 pi)        (28) of doi 10.1016/j.triboint.2013.01.017
#pragma once

#include <cmath>
#include <numbers>

#include "gearfilm/contact/hertz.hpp"

namespace gearfilm {

/// Tangent stiffness of the Hertz contact under its load w* [N/m].
inline double contact_stiffness(double load, const HertzContact& contact) { return 1.5 * load / contact.approach; }

/// f_n [Hz] for a stiffness [N/m] and the equivalent mass [kg].
inline double natural_frequency(double stiffness, double equivalent_mass) {
  return std::sqrt(stiffness / equivalent_mass) / (2.0 * std::numbers::pi);
}

}  // namespace gearfilm

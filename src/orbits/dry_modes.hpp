// Natural modes of the dry gear pair: two rotations, coupled by the stiffness of the tooth contact.
//
//   M phi'' + K phi = 0 ,   M = diag(I_g1, I_g2) ,   K = k_el r r^T ,   r = (R_b1, -R_b2)
// One mode is the rigid rotation of the geared pair, at zero frequency; the other has f_n = sqrt(k_el/m_ge)/(2 pi),
// (28) of doi 10.1016/j.triboint.2013.01.017. Both are solutions of the generalised symmetric eigenvalue problem.
#pragma once

#include <array>

namespace gearfilm {

/// Moments of inertia of the gears about their axes [kg m^2].
struct GearInertias {
  double pinion = 0.0;
  double wheel = 0.0;
};

struct RotationalMode {
  double frequency = 0.0;         ///< [Hz]
  std::array<double, 2> shape{};  ///< rotations of pinion and wheel, the larger one 1
};

/// Modes in the order of their frequency; stiffness k_el [N/m] along the line of action, base radii R_b1, R_b2 [m].
std::array<RotationalMode, 2> dry_modes(double stiffness, const std::array<double, 2>& base_radii,
                                        const GearInertias& inertias);

/// The inertias with the given equivalent mass whose ratio is that of two discs of one thickness and material on the
/// base circles, I ~ R_b^4: frequencies depend on the mass alone, the share of each gear in the motion on this ratio.
GearInertias disc_inertias(const std::array<double, 2>& base_radii, double equivalent_mass);

}  // namespace gearfilm

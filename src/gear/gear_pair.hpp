// A spur-gear pair as its drawing gives it. All lengths in [m], angles in [rad].
#pragma once

#include <optional>

namespace gearfilm {

/// One gear of the pair.
struct SpurGear {
  int teeth = 0;              ///< number of teeth Z
  double outer_radius = 0.0;  ///< tip circle radius R_a [m]
  double crowning = 0.0;      ///< lead crowning mag over half the face width [m]
  double youngs_modulus = 0.0;
  double poisson_ratio = 0.0;
  std::optional<double> profile_shift{};   ///< x [-]; absent: without backlash
  std::optional<double> root_radius{};     ///< r_f [m]; absent: dedendum 1.25 of the rack
  std::optional<double> hob_tip_radius{};  ///< rho_f of the rack [m]; absent: 0.38 m_n
  std::optional<double> bore_radius{};     ///< r_i, where the body is held [m]; absent: the body is rigid
};

/// The pair: pinion (gear 1, the driver) and wheel (gear 2).
struct SpurGearPair {
  SpurGear pinion;
  SpurGear wheel;
  double module_length = 0.0;        ///< normal module m_n [m]
  double pressure_angle = 0.0;       ///< of the basic rack, alpha [rad]
  double centre_distance = 0.0;      ///< working centre distance a_w [m]
  double face_width = 0.0;           ///< F_w [m]
  std::optional<double> backlash{};  ///< j_n along the line of action [m]; absent: none, and reverse flanks never touch
};

}  // namespace gearfilm

// What a pair is rated by, from the forces, films and temperatures that are computed of it.
//
//   sigma_H = (F E'/(2 pi F_w R_x))^(1/2)       line contact over the whole face
//   sigma_F = F cos a/(F_w m) Y_F Y_S           of both teeth, loaded where the contact is (root.hpp)
//   lambda_GF = h_Y/Ra                          micropitting.hpp
// No load factors of ISO 6336-1 are in them: what they estimate is computed.
#pragma once

#include <array>
#include <optional>

#include "gear/line_of_action.hpp"
#include "rating/micropitting.hpp"
#include "rating/root.hpp"

namespace gearfilm {

/// Each needs an input; what has none has no verdict.
struct RatingLimits {
  std::optional<double> contact{};          ///< sigma_Hlim [Pa]
  std::optional<double> root{};             ///< sigma_FE [Pa]
  std::optional<double> scuffing{};         ///< T_S of the flash temperature [K]
  std::optional<double> integral{};         ///< T_Sint [K]
  std::optional<double> film_ratio{};       ///< lambda_GFP
  double cycles = 1e9;                      ///< of the pinion
  double oil_temperature = 363.15;          ///< [K]
  std::optional<double> viscosity_40{};     ///< kinematic, at 40 degrees [m^2/s]
  std::optional<double> roughness_depth{};  ///< R_z, mean of both flanks [m]
};

struct RatingModel {
  SpurGearPair pair;
  LineOfAction line;
  double reduced_modulus = 0.0;      ///< E' [Pa]
  double pinion_speed = 0.0;         ///< [rad/s]
  double bulk_temperature = 363.15;  ///< of the warmer body [K]
  RatingLimits limits{};
  std::optional<std::array<ToothRoot, 2>> roots{};  ///< with a limit of root stresses
  MicropittingOil oil{};
  std::optional<double> mean_roughness{};  ///< Ra, mean of both flanks [m]

  /// Under a force along the line of action [N] at xi [m]. [Pa]
  double contact_stress(double force, double xi) const;
  double root_stress(std::size_t gear, double force, double xi) const;
  /// lambda_GF, with the entrainment velocity [m/s] there.
  double film_ratio(double force, double xi, double entrainment_velocity) const;

  /// sigma_Hlim Z_NT Z_L Z_v Z_R [Pa]; factors without an input are 1.
  double permissible_contact_stress() const;
  /// sigma_FE Y_NT of a gear [Pa].
  double permissible_root_stress(std::size_t gear) const;
};

}  // namespace gearfilm

// What two flanks lack beside the place where they touch, relative to what they lack there.
//
//   E_1(rho_1 - (R_b1/rho_1) x) + E_2(rho_2 + (R_b2/rho_2) x) - E_1(rho_1) - E_2(rho_2)
// x [m] along the contact, towards its outlet: the pinion's root, the wheel's tip.
#pragma once

#include <array>
#include <memory>

#include "gear/flank.hpp"

namespace gearfilm {

/// The radius of curvature of a flank [m] whose contact, at rho, is left by so much towards larger radii [m].
inline double radius_beside(double rho, double base_radius, double along) { return rho + along * base_radius / rho; }

struct LocalProfile {
  std::shared_ptr<const std::array<Flank, 2>> flanks{};  ///< none: the gap is that of the involutes
  std::array<double, 2> rho{};                           ///< at the contact's place [m]
  std::array<double, 2> base_radius{};                   ///< [m]

  double operator()(double x) const;
  bool operator==(const LocalProfile&) const = default;
};

}  // namespace gearfilm

// How the static force tilts the shafts of gears on two bearings each (train/two_bearings.hpp), at rest.
//
//   theta_i = w* t_i + M(theta) r_i ,   theta = theta_0 + theta_1 + theta_2
// theta_i: by how much the tilt of gear i opens the flanks towards positive y, w* along the line of action with the
// tilts t_i by a force and r_i by a moment; theta_0: the slope that flanks and shafts have without load. M = int p y
// dA, the moment of the dry contact at the pitch point under w*, turns both back; it falls with theta, so that there is
// one solution. Assumptions: shafts are rigid, one contact carries w*, teeth bend alike along the face, and the moment
// does not shift the gear's middle. One way: the slope stays what it is when forces change in time.
#pragma once

#include <array>
#include <optional>

#include "contact/scales.hpp"
#include "train/two_bearings.hpp"

namespace gearfilm {

struct ShaftTilt {
  std::array<double, 2> slopes{};    ///< theta_1, theta_2
  double moment = 0.0;               ///< M [N m]
  double loaded_width = 0.0;         ///< of the face, under w* [m]
  double loaded_without_tilt = 0.0;  ///< the same at theta_0 [m]

  double slope() const { return slopes[0] + slopes[1]; }
};

/// The tilt by the load of these scales, whose face has the slope theta_0; gears not on two bearings do not tilt.
/// Throws InputError where flanks would part by more than Hertz's contact allows for.
ShaftTilt shaft_tilt(const Scales& scales, const std::array<std::optional<TwoBearings>, 2>& gears,
                     double pressure_angle);

}  // namespace gearfilm

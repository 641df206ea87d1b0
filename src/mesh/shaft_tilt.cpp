#include "mesh/shaft_tilt.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elasticity/tilted_contact.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

void require_small(const Face& face, double slope) {
  const double whole = face.gap.slope + slope;
  if (std::abs(whole) <= largest_face_slope) return;
  throw InputError("the static force tilts the shafts until the flanks part by ", std::abs(whole) * face.width,
                   " m over a face of ", face.width,
                   " m, which lifts them off each other; give stiffer bearings, a longer bearing_span or a smaller "
                   "bearing_offset");
}

}  // namespace

// The secant method for theta_1 + theta_2 - w* t - M r = 0, from the side on which it never goes too far: M saturates.
ShaftTilt shaft_tilt(const Scales& scales, const std::array<std::optional<TwoBearings>, 2>& gears,
                     double pressure_angle) {
  constexpr int most_steps = 60;
  constexpr double settled = 1e-5;  // of the slope; half-widths of rows are found to 1e-6
  const Eigen::Vector2d n(std::sin(pressure_angle), std::cos(pressure_angle));
  const Face& face = *scales.solids.face;
  const double force = scales.operation.load;
  std::array<double, 2> free{}, by_moment{};
  for (std::size_t gear = 0; gear < gears.size(); ++gear) {
    if (!gears[gear]) continue;
    free[gear] = force * gears[gear]->tilt_by_force(n);
    by_moment[gear] = gears[gear]->tilt_by_moment(n);
  }
  ShaftTilt tilt{.slopes = free};
  if (free[0] + free[1] == 0.0 && face.symmetric()) return tilt;
  TiltedContact contact(scales);
  const auto left = [&](double slope) {
    require_small(face, slope);
    tilt.moment = force * scales.length * contact.solve(slope, scales.static_force, 1.0).arm;
    tilt.loaded_width = scales.length * contact.loaded_width();
    return slope - free[0] - free[1] - (by_moment[0] + by_moment[1]) * tilt.moment;
  };
  double before = 0.0, left_before = left(before);
  tilt.loaded_without_tilt = tilt.loaded_width;
  double slope = std::copysign(contact.little(), -left_before);
  for (int step = 0; step < most_steps; ++step) {
    const double rest = left(slope);
    const double change = -rest / std::max(1.0, (rest - left_before) / (slope - before));
    if (std::abs(change) <= settled * std::max(std::abs(slope), contact.little())) {
      for (std::size_t gear = 0; gear < gears.size(); ++gear) {
        tilt.slopes[gear] = free[gear] + by_moment[gear] * tilt.moment;
      }
      return tilt;
    }
    before = std::exchange(slope, slope + change);
    left_before = rest;
  }
  throw SolveError(
      "how the static force tilts the shafts is not found; give stiffer bearings or a longer bearing_span");
}

}  // namespace gearfilm

// The heights of both flanks about the place where they touch.
//
//   t(x, y, t) = z_1(s_1 - x, y) + z_2(s_2 + x, y) ,   ds_1/dt = u_1 ,  ds_2/dt = -u_2
// x [m] along the contact towards its outlet, y across it: heights of either flank travel with it, towards +x. They
// take t from the gap. s_i = rho_i^2/(2 R_bi) [m], the length of the involute at the contact.
#pragma once

#include <array>
#include <memory>

#include "roughness/topography.hpp"

namespace gearfilm {

struct ContactTexture {
  std::shared_ptr<const std::array<Topography, 2>> flanks{};  ///< of pinion and wheel; none: smooth
  std::array<double, 2> place{};                              ///< s_1, s_2 [m]
  bool moves = false;                                         ///< in time; at rest heights stand in the contact

  /// Heights that travel with either flank, with their derivatives by x.
  std::array<SurfaceHeight, 2> along(double x) const {
    SurfaceHeight first = (*flanks)[0].along(place[0] - x);
    first.slope = -first.slope;
    return {first, (*flanks)[1].along(place[1] + x)};
  }
  double across(double y) const { return (*flanks)[0].across(y).value + (*flanks)[1].across(y).value; }
  bool travels() const { return flanks && ((*flanks)[0].travels() || (*flanks)[1].travels()); }

  bool operator==(const ContactTexture&) const = default;
};

}  // namespace gearfilm

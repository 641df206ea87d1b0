// Where a point of a flank is in a contact that travels.
//
// A flank's coordinate is the arc length of its involute from the base circle, s = rho^2/(2 R_b), with the radii of
// curvature rho_1 = R_b1 tan alpha' + xi, rho_2 = R_b2 tan alpha' - xi. In the contact at xi the point is at
//   pinion  x = s_1(xi) - s        wheel  x = s - s_2(xi) ,     dx/dxi = rho_i/R_bi
// for both flanks move towards +x.
#pragma once

#include "gear/line_of_action.hpp"

namespace gearfilm {

class FlankPath {
public:
  /// The path on the pinion's flank or on the wheel's.
  FlankPath(const LineOfAction& line, bool pinion);

  /// rho and s of the point at the middle of the contact at xi [m].
  double curvature_radius(double xi) const;
  double arc_length(double xi) const;
  /// xi of the contact that has a point in its middle [m].
  double position_of(double s) const;
  /// x of a point in the contact at xi [m].
  double place(double s, double xi) const { return pinion_ ? arc_length(xi) - s : s - arc_length(xi); }
  /// s of the point that is at x in the contact at xi [m].
  double point(double x, double xi) const { return pinion_ ? arc_length(xi) - x : arc_length(xi) + x; }
  /// s of the first and the last point that contacts have in their middle, the smaller one first.
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

private:
  LineOfAction line_;
  bool pinion_;
  double base_radius_;
  double radius_at_pitch_;  ///< rho at xi = 0 [m]
  double lowest_, highest_;
};

}  // namespace gearfilm

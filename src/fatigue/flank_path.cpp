#include "fatigue/flank_path.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

FlankPath::FlankPath(const LineOfAction& line, bool pinion)
    : line_(line),
      pinion_(pinion),
      base_radius_(pinion ? line.base_radius_pinion() : line.base_radius_wheel()),
      radius_at_pitch_(base_radius_ * std::tan(line.working_pressure_angle())),
      lowest_(std::min(arc_length(line.entry()), arc_length(line.exit()))),
      highest_(std::max(arc_length(line.entry()), arc_length(line.exit()))) {}

double FlankPath::curvature_radius(double xi) const { return radius_at_pitch_ + (pinion_ ? xi : -xi); }

double FlankPath::arc_length(double xi) const { return line_.involute_lengths(xi)[pinion_ ? 0 : 1]; }

double FlankPath::position_of(double s) const {
  const double way = std::sqrt(2.0 * base_radius_ * s) - radius_at_pitch_;
  return pinion_ ? way : -way;
}

}  // namespace gearfilm

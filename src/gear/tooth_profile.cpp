// Generation by a rack: with the rack rolled by u from where its tip stands lowest, the centre of the tip's rounding is
// C = (u, r - D), the point of the fillet Q = C + rho_f n on the line from the pitch point through C, turned back by
// (u - e_c)/r. n points away from the rack's centre: with D > 0 outwards to the root.
#include "gear/tooth_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gear/involute.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

constexpr int outline_points = 600;  // on the fillet, and on the involute

/// What a tooth lacks on the reference circle: half of the backlash, from the line of action [m].
double thinning(const SpurGearPair& pair) { return 0.5 * pair.backlash.value_or(0.0) / std::cos(pair.pressure_angle); }

}  // namespace

ToothProfile::ToothProfile(const SpurGear& gear, const SpurGearPair& pair, double profile_shift, std::string name)
    : name_(std::move(name)),
      teeth_(gear.teeth),
      base_radius_(0.5 * gear.teeth * pair.module_length * std::cos(pair.pressure_angle)),
      reference_radius_(0.5 * gear.teeth * pair.module_length) {
  const double m = pair.module_length;
  thickness_ = tooth_thickness(pair, profile_shift);
  reference_angle_ = involute(pair.pressure_angle) + 0.5 * thickness_ / reference_radius_;
  hob_tip_radius_ = gear.hob_tip_radius.value_or(0.38 * m);
  generate_fillet(pair, profile_shift, gear.root_radius.value_or(standard_root_radius(gear, pair, profile_shift)));
}

double ToothProfile::half_angle(double radius) const {
  return reference_angle_ - involute(std::acos(std::min(1.0, base_radius_ / radius)));
}

void ToothProfile::generate_fillet(const SpurGearPair& pair, double profile_shift, double root_radius) {
  const double m = pair.module_length, r = reference_radius_, tan = std::tan(pair.pressure_angle);
  const double dedendum = r - root_radius + profile_shift * m;
  const auto fail = [&](const std::string& why) {
    throw InputError(name_, "_root_radius = ", std::to_string(root_radius), " m ", why);
  };
  if (!(root_radius > 0.0) || dedendum <= 0.0) fail("is not below the reference line of the rack: give a smaller one");
  // What a rounding of the rack's tip takes of its flat top.
  const double top = 0.25 * pi * m - dedendum * tan;
  const double taken = (1.0 - std::sin(pair.pressure_angle)) / std::cos(pair.pressure_angle);
  if (top < 0.0) fail("needs a rack that is pointed before it reaches it: give a larger one");
  hob_tip_radius_ = std::min(hob_tip_radius_, top / taken);
  double depth = dedendum - profile_shift * m - hob_tip_radius_;  // D
  if (std::abs(depth) < 1e-9) {
    hob_tip_radius_ -= 2e-9;
    depth = dedendum - profile_shift * m - hob_tip_radius_;
  }
  rack_depth_ = depth;
  rack_offset_ = top - hob_tip_radius_ * taken;
  slack_ = 0.5 * thinning(pair) / r;
  root_radius_ = root_radius;
  const OutlinePoint root = fillet_point(0.0);
  root_half_angle_ = std::atan2(root.x, root.y);
  end_fillet_on_involute(depth / tan);
}

/// Of the fillet, where the rack is rolled by u [m] from where its tip stands lowest.
OutlinePoint ToothProfile::fillet_point(double u) const {
  const double size = std::hypot(u, rack_depth_), sign = rack_depth_ > 0.0 ? 1.0 : -1.0;
  const double qx = u + hob_tip_radius_ * sign * u / size;
  const double qy = reference_radius_ - rack_depth_ - hob_tip_radius_ * sign * rack_depth_ / size;
  const double turn = (u - rack_offset_) / reference_radius_;
  const double x = qx * std::cos(turn) - qy * std::sin(turn), y = qx * std::sin(turn) + qy * std::cos(turn);
  const double angle = pi / teeth_ - std::atan2(x, y) - slack_, radius = std::hypot(x, y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// The fillet goes over into the involute at its last point. Where the rack undercuts the tooth its last point lies
// beyond the involute's foot, and the tooth ends its fillet where this first meets the involute.
void ToothProfile::end_fillet_on_involute(double last) {
  const auto beyond = [&](double u) {
    const OutlinePoint point = fillet_point(u);
    const double radius = std::hypot(point.x, point.y);
    return radius < base_radius_ ? -1.0 : std::atan2(point.x, point.y) - half_angle(radius);
  };
  double end = last;
  const OutlinePoint joint = fillet_point(last);
  if (std::hypot(joint.x, joint.y) < base_radius_ || std::abs(beyond(last)) > 1e-9) {
    undercut_ = true;
    int n = 0;
    while (n <= outline_points && beyond(last * n / outline_points) < 0.0) ++n;
    if (n == 0 || n > outline_points) {
      throw InputError(name_ + ": the rack cuts the whole involute away: raise " + name_ + "_root_radius or " + name_ +
                       "_profile_shift");
    }
    double low = last * (n - 1) / outline_points, high = last * n / outline_points;
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = 0.5 * (low + high);
      (beyond(middle) < 0.0 ? low : high) = middle;
    }
    end = high;
  }
  for (int n = 0; n <= outline_points; ++n) fillet_.push_back(fillet_point(end * n / outline_points));
  form_radius_ = std::hypot(fillet_.back().x, fillet_.back().y);
}

ToothLoad ToothProfile::load_at(double rho) const {
  const double radius = std::hypot(base_radius_, rho);
  if (radius < form_radius_ * (1.0 - 1e-9)) {
    throw InputError(name_, "_root_radius: the flank is used down to the radius ", radius, " m, but ends at ",
                     form_radius_, " m, where the fillet begins: reduce ", name_, "_root_radius or ", name_,
                     "_hob_tip_radius");
  }
  const double gamma = half_angle(radius);
  const double angle = std::acos(base_radius_ / radius) - gamma;
  return {radius * std::cos(gamma), radius * std::sin(gamma), angle, base_radius_ / std::cos(angle)};
}

std::vector<OutlinePoint> ToothProfile::outline_to(double rho) const {
  std::vector<OutlinePoint> outline = fillet_;
  const double end = std::hypot(base_radius_, rho);
  // Equal steps in rho, in which the involute is smooth down to its foot.
  const double begin = std::sqrt(std::max(0.0, form_radius_ * form_radius_ - base_radius_ * base_radius_));
  if (end <= form_radius_) return outline;
  for (int n = 1; n <= outline_points; ++n) {
    const double radius = std::hypot(base_radius_, begin + (rho - begin) * n / outline_points),
                 gamma = half_angle(radius);
    outline.push_back({radius * std::cos(gamma), radius * std::sin(gamma)});
  }
  return outline;
}

double tooth_thickness(const SpurGearPair& pair, double profile_shift) {
  const double m = pair.module_length;
  return 0.5 * pi * m + 2.0 * profile_shift * m * std::tan(pair.pressure_angle) - thinning(pair);
}

double tooth_thickness_at(double radius, const SpurGear& gear, const SpurGearPair& pair, double profile_shift) {
  const double reference = 0.5 * gear.teeth * pair.module_length, base = reference * std::cos(pair.pressure_angle);
  return 2.0 * radius *
         (tooth_thickness(pair, profile_shift) / (2.0 * reference) + involute(pair.pressure_angle) -
          involute(std::acos(base / radius)));
}

double standard_root_radius(const SpurGear& gear, const SpurGearPair& pair, double profile_shift) {
  return (0.5 * gear.teeth - 1.25 + profile_shift) * pair.module_length;
}

double sum_of_profile_shifts(const SpurGearPair& pair) {
  const int teeth = pair.pinion.teeth + pair.wheel.teeth;
  const double reference = 0.5 * teeth * pair.module_length;
  const double working = std::acos(reference * std::cos(pair.pressure_angle) / pair.centre_distance);
  return teeth * (involute(working) - involute(pair.pressure_angle)) / (2.0 * std::tan(pair.pressure_angle));
}

std::array<double, 2> profile_shifts(const SpurGearPair& pair) {
  const SpurGear& pinion = pair.pinion;
  const SpurGear& wheel = pair.wheel;
  const double m = pair.module_length, sum = sum_of_profile_shifts(pair);
  if (pinion.profile_shift && wheel.profile_shift) return {*pinion.profile_shift, *wheel.profile_shift};
  if (pinion.profile_shift) return {*pinion.profile_shift, sum - *pinion.profile_shift};
  if (wheel.profile_shift) return {sum - *wheel.profile_shift, *wheel.profile_shift};
  const auto addendum = [m](const SpurGear& gear) { return (gear.outer_radius - 0.5 * gear.teeth * m) / m - 1.0; };
  const double cut = 0.5 * (sum - addendum(pinion) - addendum(wheel));
  return {addendum(pinion) + cut, addendum(wheel) + cut};
}

}  // namespace gearfilm

// Kinematics along the line of action of an involute spur-gear pair, eqs (13)-(19) of
// doi 10.1016/j.triboint.2013.01.017. With t = tan(alpha'), cos(alpha') = (R_b1+R_b2)/a_w:
//   R_1x = R_b1 t + xi,  R_2x = R_b2 t - xi,  R_x = R_1x R_2x/(R_1x+R_2x)
//   xi_s = -( sqrt(R_a2^2-R_b2^2) - R_b2 t ),  xi_e = sqrt(R_a1^2-R_b1^2) - R_b1 t,  p_b = 2 pi R_b1/Z_1
#include "gear/line_of_action.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "gear/involute.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

namespace {

using std::numbers::pi;

// The checks state what is right, so that NaN fails them: every comparison with it is false.
void require_positive_length(double value, const std::string& parameter) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(parameter, " = ", value,
                   " m is not a length above zero: give the dimension of the drawing in metres");
}

void require_teeth(int teeth, const std::string& parameter) {
  if (teeth > 0) return;
  throw InputError(parameter, " = ", teeth, " is not a number of teeth: give a positive integer");
}

void require_crowning(double crowning, double face_width, const std::string& parameter) {
  if (crowning >= 0.0 && crowning < 0.5 * face_width) return;
  if (crowning >= 0.5 * face_width && std::isfinite(crowning)) {
    throw InputError(parameter, " = ", crowning, " m is half of gear_face_width = ", face_width,
                     " m or more, rounder than a half circle: give both in metres");
  }
  throw InputError(parameter, " = ", crowning,
                   " m is not a lead crowning: give zero (straight flanks) or a positive length in metres");
}

void check_dimensions(const SpurGearPair& pair) {
  require_teeth(pair.pinion.teeth, "pinion_teeth");
  require_teeth(pair.wheel.teeth, "wheel_teeth");
  require_positive_length(pair.pinion.outer_radius, "pinion_outer_radius");
  require_positive_length(pair.wheel.outer_radius, "wheel_outer_radius");
  require_positive_length(pair.module_length, "gear_module");
  require_positive_length(pair.centre_distance, "gear_centre_distance");
  require_positive_length(pair.face_width, "gear_face_width");
  require_crowning(pair.pinion.crowning, pair.face_width, "pinion_crowning");
  require_crowning(pair.wheel.crowning, pair.face_width, "wheel_crowning");
  if (!(pair.pressure_angle > 0.0 && pair.pressure_angle < pi / 2.0)) {
    throw InputError("gear_pressure_angle_deg = ", pair.pressure_angle * 180.0 / pi,
                     " is not between 0 and 90 degrees: give the angle of the basic rack (20 is usual)");
  }
}

double base_radius(const SpurGear& gear, const SpurGearPair& pair) {
  return gear.teeth * pair.module_length * std::cos(pair.pressure_angle) / 2.0;
}

// Tangent length from the base circle to the tip circle: the largest radius of curvature of the flank [m].
double tip_radius_of_curvature(const SpurGear& gear, double base_radius, const std::string& name) {
  if (gear.outer_radius <= base_radius) {
    throw InputError(name, "_outer_radius = ", gear.outer_radius, " m is not above the base radius ", base_radius,
                     " m: there is no involute flank; enlarge ", name, "_outer_radius or reduce ", name,
                     "_teeth, gear_module");
  }
  return std::sqrt((gear.outer_radius - base_radius) * (gear.outer_radius + base_radius));
}

void check_flank(double smallest_radius, const std::string& gear, const std::string& mate) {
  if (smallest_radius > 0.0) return;
  throw InputError("the radius of curvature of the ", gear, " flank falls to ", smallest_radius,
                   " m on the path of "
                   "contact: below the base circle there is no involute; reduce ",
                   mate, "_outer_radius");
}

// Towards the tip the flanks of a tooth approach each other: at the angle alpha_a = acos(R_b/R_a) it is thinner than on
// the working pitch circle R_w by 2 R_w (inv alpha_a - inv alpha'), relative to its radius. Both teeth together have at
// most the pitch 2 pi R_w1/Z_1 there. How they share it is not given; what both lose must be less.
void check_tips(const SpurGearPair& pair, double working_pressure_angle) {
  const int teeth = pair.pinion.teeth + pair.wheel.teeth;
  const auto loss = [&](const SpurGear& gear) {
    const double tip_angle = std::acos(base_radius(gear, pair) / gear.outer_radius);
    const double pitch_radius = pair.centre_distance * gear.teeth / teeth;
    return 2.0 * pitch_radius * (involute(tip_angle) - involute(working_pressure_angle));
  };
  const double lost = loss(pair.pinion) + loss(pair.wheel), pitch = 2.0 * pi * pair.centre_distance / teeth;
  if (lost < pitch) return;
  throw InputError("the teeth would be pointed below the tip circles: towards them they lose ", lost,
                   " m of thickness, and have the working pitch of ", pitch,
                   " m together; reduce pinion_outer_radius, wheel_outer_radius, or check gear_module and "
                   "gear_centre_distance");
}

void check_path(const SpurGearPair& pair, double entry, double exit, double base_pitch) {
  const double contact_ratio = (exit - entry) / base_pitch;
  const double tips = pair.pinion.outer_radius + pair.wheel.outer_radius;
  const double reference = 0.5 * (pair.pinion.teeth + pair.wheel.teeth) * pair.module_length;
  if (pair.centre_distance >= tips || contact_ratio <= 0.0) {
    throw InputError("gear_centre_distance = ", pair.centre_distance, " m keeps the teeth apart: the tip radii are ",
                     tips, " m together, and the reference circles touch at ", reference,
                     " m; check gear_centre_distance, gear_module and the numbers of teeth");
  }
  if (contact_ratio < 1.0) {
    throw InputError("contact ratio ", contact_ratio, " is below 1: the pair cannot transmit motion; enlarge the tip ",
                     "circles (pinion_outer_radius, wheel_outer_radius), or check gear_centre_distance = ",
                     pair.centre_distance, " m, where the reference circles touch at ", reference, " m");
  }
  // The pitch point is the reference of every scale, so it has to lie on the path of contact.
  if (entry >= 0.0) {
    throw InputError("the path of contact begins ", entry, " m after the pitch point and does not contain it; ",
                     "enlarge wheel_outer_radius or reduce gear_centre_distance");
  }
  if (exit <= 0.0) {
    throw InputError("the path of contact ends ", -exit, " m before the pitch point and does not contain it; ",
                     "enlarge pinion_outer_radius or reduce gear_centre_distance");
  }
}

}  // namespace

LineOfAction::LineOfAction(const SpurGearPair& pair) {
  check_dimensions(pair);
  base_radius_pinion_ = base_radius(pair.pinion, pair);
  base_radius_wheel_ = base_radius(pair.wheel, pair);
  const double base_radii = base_radius_pinion_ + base_radius_wheel_;
  if (pair.centre_distance <= base_radii) {
    throw InputError("gear_centre_distance = ", pair.centre_distance, " m is not above the sum of the base radii ",
                     base_radii, " m: the base circles overlap; enlarge gear_centre_distance or reduce gear_module");
  }
  working_pressure_angle_ = std::acos(base_radii / pair.centre_distance);
  speed_ratio_ = static_cast<double>(pair.pinion.teeth) / pair.wheel.teeth;
  base_pitch_ = 2.0 * pi * base_radius_pinion_ / pair.pinion.teeth;

  const double tip_pinion = tip_radius_of_curvature(pair.pinion, base_radius_pinion_, "pinion");
  const double tip_wheel = tip_radius_of_curvature(pair.wheel, base_radius_wheel_, "wheel");
  entry_ = radius_wheel(0.0) - tip_wheel;
  exit_ = tip_pinion - radius_pinion(0.0);
  check_flank(radius_pinion(entry_), "pinion", "wheel");
  check_flank(radius_wheel(exit_), "wheel", "pinion");
  check_path(pair, entry_, exit_, base_pitch_);
  check_tips(pair, working_pressure_angle_);

  // R_iy = F_w^2/(8 mag_i); the curvatures 1/R_iy add, so one straight flank or two need no special case.
  const double crowning = pair.pinion.crowning + pair.wheel.crowning;
  radius_y_ =
      crowning > 0.0 ? pair.face_width * pair.face_width / (8.0 * crowning) : std::numeric_limits<double>::infinity();
}

double LineOfAction::radius_pinion(double xi) const {
  return base_radius_pinion_ * std::tan(working_pressure_angle_) + xi;
}

double LineOfAction::radius_wheel(double xi) const {
  return base_radius_wheel_ * std::tan(working_pressure_angle_) - xi;
}

std::array<double, 2> LineOfAction::involute_lengths(double xi) const {
  const double pinion = radius_pinion(xi), wheel = radius_wheel(xi);
  return {0.5 * pinion * pinion / base_radius_pinion_, 0.5 * wheel * wheel / base_radius_wheel_};
}

double LineOfAction::radius_x(double xi) const {
  const double pinion = radius_pinion(xi);
  const double wheel = radius_wheel(xi);
  return pinion * wheel / (pinion + wheel);
}

// R_x is a parabola over the path, largest midway between the base circles: its ends have the smallest.
std::array<double, 2> LineOfAction::relative_radii() const {
  const double top = std::clamp(0.5 * (radius_wheel(0.0) - radius_pinion(0.0)), entry_, exit_);
  const double reference = radius_x(0.0);
  return {std::min(radius_x(entry_), radius_x(exit_)) / reference, radius_x(top) / reference};
}

double LineOfAction::entrainment_velocity(double xi, double pinion_speed) const {
  // u_m = Omega_1 [R_b1 tan(alpha') + (1-tau) xi/2]
  return pinion_speed * (radius_pinion(0.0) + (1.0 - speed_ratio_) * xi / 2.0);
}

double LineOfAction::sliding_velocity(double xi, double pinion_speed) const {
  // u_1 - u_2 = Omega_1 (R_1x - tau R_2x); the terms without xi cancel because tau R_b2 = R_b1, and are left
  // out so that the pitch point rolls exactly.
  return pinion_speed * (1.0 + speed_ratio_) * xi;
}

double LineOfAction::travel_velocity(double pinion_speed) const { return pinion_speed * base_radius_pinion_; }

std::vector<double> LineOfAction::contact_positions(double xi) const {
  assert(std::isfinite(xi));
  // A contact that enters or leaves sits at an end of the path up to round-off: it counts as within.
  constexpr double tolerance = 1e-12;  // in base pitches
  const int first = static_cast<int>(std::floor((exit_ - xi) / base_pitch_ + tolerance));
  const int last = static_cast<int>(std::ceil((entry_ - xi) / base_pitch_ - tolerance));
  std::vector<double> positions;
  for (int n = first; n >= last; --n) positions.push_back(std::clamp(xi + n * base_pitch_, entry_, exit_));
  return positions;
}

double LineOfAction::loss_factor() const {
  std::vector<double> ends;
  for (int n = 0; n < contact_ratio(); ++n)
    ends.insert(ends.end(), {entry_ + n * base_pitch_, exit_ - n * base_pitch_});
  std::ranges::sort(ends);
  const auto primitive = [](double xi) { return 0.5 * xi * std::abs(xi); };  // of |xi|
  double sum = 0.0;
  for (std::size_t n = 1; n < ends.size(); ++n) {
    const auto contacts = static_cast<double>(contact_positions(0.5 * (ends[n - 1] + ends[n])).size());
    sum += (primitive(ends[n]) - primitive(ends[n - 1])) / contacts;
  }
  return (1.0 + speed_ratio_) / (base_radius_pinion_ * base_pitch_) * sum;
}

double mesh_frequency(const SpurGearPair& pair, double pinion_speed) {
  return pinion_speed * pair.pinion.teeth / (2.0 * pi);
}

double equivalent_mass(const LineOfAction& line, double pinion_inertia, double wheel_inertia) {
  assert(pinion_inertia > 0.0 && wheel_inertia > 0.0);
  const double r1 = line.base_radius_pinion();
  const double r2 = line.base_radius_wheel();
  return 1.0 / (r1 * r1 / pinion_inertia + r2 * r2 / wheel_inertia);
}

}  // namespace gearfilm

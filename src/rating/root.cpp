#include "rating/root.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gear/involute.hpp"
#include "gear/tooth_profile.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;
using std::numbers::sqrt3;

}  // namespace

ToothRoot::ToothRoot(const SpurGear& gear, const SpurGearPair& pair, double profile_shift)
    : teeth_(gear.teeth),
      shift_(profile_shift),
      module_(pair.module_length),
      face_width_(pair.face_width),
      rack_angle_(pair.pressure_angle),
      base_radius_(0.5 * gear.teeth * pair.module_length * std::cos(pair.pressure_angle)) {
  const double root = gear.root_radius.value_or(standard_root_radius(gear, pair, profile_shift));
  const double dedendum = 0.5 * teeth_ - root / module_ + shift_;  // h_fP
  rack_tip_ = gear.hob_tip_radius.value_or(0.38 * module_) / module_;
  const double E =
      0.25 * pi - dedendum * std::tan(rack_angle_) - (1.0 - std::sin(rack_angle_)) * rack_tip_ / std::cos(rack_angle_);
  depth_ = rack_tip_ - dedendum + shift_;
  const double H = 2.0 / teeth_ * (0.5 * pi - E) - pi / 3.0;
  angle_ = pi / 6.0;
  double before = 0.0;
  for (int n = 0; n < 200 && std::abs(angle_ - before) > 1e-15; ++n) {
    before = angle_;
    angle_ = 2.0 * depth_ / teeth_ * std::tan(before) - H;
  }
  const double cosine = std::cos(angle_), room = teeth_ * cosine * cosine - 2.0 * depth_;
  thickness_ = teeth_ * std::sin(pi / 3.0 - angle_) + sqrt3 * (depth_ / cosine - rack_tip_);
  if (!(std::abs(angle_ - before) <= 1e-12 && cosine > 0.0 && room > 0.0 && thickness_ > 0.0)) {
    throw InputError("a tooth of ", gear.teeth, " teeth and the root radius ", root,
                     " m has no place at its root where tangents lean by 30 degrees: check teeth, profile_shift, "
                     "root_radius and hob_tip_radius, or leave rating.root_limit away");
  }
  fillet_ = rack_tip_ + 2.0 * depth_ * depth_ / (cosine * room);
}

RootFactors ToothRoot::factors(double rho) const {
  const double radius = std::hypot(base_radius_, rho), at = std::acos(std::min(1.0, base_radius_ / radius));
  const double g = (0.5 * pi + 2.0 * shift_ * std::tan(rack_angle_)) / teeth_ + involute(rack_angle_) - involute(at);
  const double load_angle = at - g;
  const double arm = 0.5 * ((std::cos(g) - std::sin(g) * std::tan(load_angle)) * 2.0 * radius / module_ -
                            teeth_ * std::cos(pi / 3.0 - angle_) - depth_ / std::cos(angle_) + rack_tip_);
  const double L = thickness_ / arm, notch = thickness_ / (2.0 * fillet_);
  return {.form = 6.0 * arm * std::cos(load_angle) / (thickness_ * thickness_ * std::cos(rack_angle_)),
          .stress_correction = (1.2 + 0.13 * L) * std::pow(notch, 1.0 / (1.21 + 2.3 / L))};
}

double ToothRoot::stress(double force, double rho) const {
  const RootFactors of = factors(rho);
  return force * std::cos(rack_angle_) / (face_width_ * module_) * of.form * of.stress_correction;
}

double root_life_factor(double cycles) {
  constexpr double first = 1e3, knee = 3e6, last = 1e10;
  if (cycles <= first) return 2.5;
  if (cycles <= knee) return std::pow(knee / cycles, std::log(2.5) / std::log(knee / first));
  return std::pow(knee / std::min(cycles, last), std::log(1.0 / 0.85) / std::log(last / knee));
}

}  // namespace gearfilm

#include "rating/pitting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gear/line_of_action.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

// Stresses of formulas are in MPa, lengths in mm, viscosities in mm^2/s.
constexpr double hard = 1200.0, soft = 850.0;

/// C of Z_L and Z_v for a limit in MPa.
double hardness_constant(double limit) {
  if (limit > hard) return 0.91;
  return limit < soft ? 0.83 : limit / 4375.0 + 0.6357;
}

double roughness_exponent(double limit) {
  if (limit > hard) return 0.08;
  return limit < soft ? 0.15 : 0.32 - 0.0002 * limit;
}

/// M of a gear at its inner point of single contact.
double inner_point_factor(const SpurGear& gear, const SpurGear& mate, double base_radius, double mate_base_radius,
                          const LineOfAction& line) {
  const auto tip = [](const SpurGear& of, double base) {
    const double ratio = of.outer_radius / base;
    return std::sqrt(ratio * ratio - 1.0);
  };
  const double own = tip(gear, base_radius) - 2.0 * pi / gear.teeth,
               other = tip(mate, mate_base_radius) - (line.contact_ratio() - 1.0) * 2.0 * pi / mate.teeth;
  return std::tan(line.working_pressure_angle()) / std::sqrt(own * other);
}

}  // namespace

double elasticity_factor(const SpurGear& pinion, const SpurGear& wheel) {
  const auto softness = [](const SpurGear& of) {
    return (1.0 - of.poisson_ratio * of.poisson_ratio) / of.youngs_modulus;
  };
  return 1.0 / std::sqrt(pi * (softness(pinion) + softness(wheel)));
}

NominalContactStress nominal_contact_stress(const SpurGearPair& pair, double pinion_torque) {
  const LineOfAction line(pair);
  const double working = line.working_pressure_angle(), rack = pair.pressure_angle;
  const double d_1 = pair.pinion.teeth * pair.module_length, force = 2.0 * pinion_torque / d_1;
  const double u = static_cast<double>(pair.wheel.teeth) / pair.pinion.teeth;
  NominalContactStress nominal;
  nominal.elasticity_factor = elasticity_factor(pair.pinion, pair.wheel);
  nominal.zone_factor = std::sqrt(2.0 * std::cos(working) / std::sin(working)) / std::cos(rack);
  nominal.ratio_factor = std::sqrt((4.0 - line.contact_ratio()) / 3.0);
  const double base_1 = line.base_radius_pinion(), base_2 = line.base_radius_wheel();
  nominal.pinion_factor = std::max(1.0, inner_point_factor(pair.pinion, pair.wheel, base_1, base_2, line));
  nominal.wheel_factor = std::max(1.0, inner_point_factor(pair.wheel, pair.pinion, base_2, base_1, line));
  nominal.stress = nominal.zone_factor * nominal.elasticity_factor * nominal.ratio_factor *
                   std::sqrt(force / (d_1 * pair.face_width) * (u + 1.0) / u);
  return nominal;
}

double contact_life_factor(double cycles) {
  constexpr double first = 1e5, knee = 5e7, last = 1e10;
  if (cycles <= first) return 1.6;
  if (cycles <= knee) return std::pow(knee / cycles, std::log(1.6) / std::log(knee / first));
  return std::pow(knee / std::min(cycles, last), std::log(1.0 / 0.85) / std::log(last / knee));
}

double lubricant_factor(double viscosity, double limit) {
  const double C = hardness_constant(1e-6 * limit), root = 1.2 + 134.0 / (1e6 * viscosity);
  return C + 4.0 * (1.0 - C) / (root * root);
}

double velocity_factor(double velocity, double limit) {
  const double C = hardness_constant(1e-6 * limit) + 0.02;
  return C + 2.0 * (1.0 - C) / std::sqrt(0.8 + 32.0 / velocity);
}

double roughness_factor(double roughness_depth, double reduced_radius, double limit) {
  const double relative = 1e6 * roughness_depth * std::cbrt(10.0 / (1e3 * reduced_radius));
  return std::pow(3.0 / relative, roughness_exponent(1e-6 * limit));
}

}  // namespace gearfilm

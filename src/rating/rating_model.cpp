#include "rating/rating_model.hpp"

#include <cmath>
#include <numbers>

#include "rating/pitting.hpp"

namespace gearfilm {

double RatingModel::contact_stress(double force, double xi) const {
  if (!(force > 0.0)) return 0.0;
  return std::sqrt(force / pair.face_width * reduced_modulus / (2.0 * std::numbers::pi * line.radius_x(xi)));
}

double RatingModel::root_stress(std::size_t gear, double force, double xi) const {
  if (!roots || !(force > 0.0)) return 0.0;
  return (*roots)[gear].stress(force, gear == 0 ? line.radius_pinion(xi) : line.radius_wheel(xi));
}

double RatingModel::film_ratio(double force, double xi, double entrainment_velocity) const {
  if (!mean_roughness || !(force > 0.0)) return 0.0;
  return micropitting_film({line.radius_x(xi), entrainment_velocity, force / pair.face_width}, oil) / *mean_roughness;
}

double RatingModel::permissible_contact_stress() const {
  const double limit = *limits.contact;
  const double velocity = 0.5 * pinion_speed * pair.pinion.teeth * pair.module_length;
  double factors = contact_life_factor(limits.cycles) * velocity_factor(velocity, limit);
  if (limits.viscosity_40) factors *= lubricant_factor(*limits.viscosity_40, limit);
  if (limits.roughness_depth) factors *= roughness_factor(*limits.roughness_depth, line.radius_x(0.0), limit);
  return limit * factors;
}

double RatingModel::permissible_root_stress(std::size_t gear) const {
  const double ratio = static_cast<double>(pair.pinion.teeth) / pair.wheel.teeth;
  return *limits.root * root_life_factor(gear == 0 ? limits.cycles : ratio * limits.cycles);
}

}  // namespace gearfilm

#include "contact/face_law.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"

namespace gearfilm {

double FaceLaw::Curve::value(double log_force) const {
  const double inside = std::clamp(log_force, low, high), x = (2.0 * inside - low - high) / (high - low);
  double sum = 0.0;
  for (std::size_t n = coefficients.size(); n-- > 0;) sum = sum * x + coefficients[n];
  return sum + (log_force - inside) * slope(inside);
}

double FaceLaw::Curve::slope(double log_force) const {
  const double inside = std::clamp(log_force, low, high), x = (2.0 * inside - low - high) / (high - low);
  double sum = 0.0;
  for (std::size_t n = coefficients.size(); n-- > 1;) sum = sum * x + static_cast<double>(n) * coefficients[n];
  return sum * 2.0 / (high - low);
}

FaceLaw::Curve FaceLaw::fitted(const std::vector<FaceContact>& contacts, double FaceContact::*quantity,
                               bool logarithm) {
  constexpr Eigen::Index terms = 6;
  Curve curve{{}, std::log(contacts.front().force), std::log(contacts.back().force)};
  const auto count = static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd powers(count, std::min(terms, count));
  Eigen::VectorXd values(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    const FaceContact& contact = contacts[static_cast<std::size_t>(n)];
    const double x = (2.0 * std::log(contact.force) - curve.low - curve.high) / (curve.high - curve.low);
    for (Eigen::Index power = 0; power < powers.cols(); ++power) {
      powers(n, power) = std::pow(x, static_cast<double>(power));
    }
    values[n] = logarithm ? std::log(contact.*quantity) : contact.*quantity;
  }
  const Eigen::VectorXd solved = least_squares(powers, values);
  curve.coefficients.assign(solved.begin(), solved.end());
  return curve;
}

FaceLaw::FaceLaw(double nearest, std::array<double, 2> relative_radii,
                 const std::array<std::vector<FaceContact>, 2>& contacts)
    : nearest_(nearest), log_radii_{std::log(relative_radii[0]), std::log(relative_radii[1])} {
  for (std::size_t n = 0; n < 2; ++n) {
    std::vector<FaceContact> beyond = contacts[n];
    for (FaceContact& contact : beyond) contact.approach -= nearest;
    curves_[n] = {.approach = fitted(beyond, &FaceContact::approach, true),
                  .half_width = fitted(beyond, &FaceContact::half_width, true),
                  .pressure = fitted(beyond, &FaceContact::pressure, true),
                  .arm = fitted(beyond, &FaceContact::arm, false)};
  }
}

double FaceLaw::weight(double relative_radius) const {
  return (std::log(relative_radius) - log_radii_[0]) / (log_radii_[1] - log_radii_[0]);
}

double FaceLaw::log_approach(double log_force, double part) const {
  return std::lerp(curves_[0].approach.value(log_force), curves_[1].approach.value(log_force), part);
}

double FaceLaw::power(double log_force, double part) const {
  return std::lerp(curves_[0].approach.slope(log_force), curves_[1].approach.slope(log_force), part);
}

FaceContact FaceLaw::at_force(double force, double relative_radius) const {
  const double at = std::log(force), part = weight(relative_radius);
  const auto between = [&](Curve AtRadius::*curve) {
    return std::lerp((curves_[0].*curve).value(at), (curves_[1].*curve).value(at), part);
  };
  return {.force = force,
          .approach = approach(force, relative_radius),
          .half_width = std::exp(between(&AtRadius::half_width)),
          .pressure = std::exp(between(&AtRadius::pressure)),
          .arm = between(&AtRadius::arm)};
}

double FaceLaw::approach(double force, double relative_radius) const {
  if (force <= 0.0) return 0.0;
  return std::exp(log_approach(std::log(force), weight(relative_radius)));
}

double FaceLaw::stiffness(double force, double relative_radius) const {
  if (force <= 0.0) return 0.0;
  const double at = std::log(force), part = weight(relative_radius);
  return force / (power(at, part) * std::exp(log_approach(at, part)));
}

// Newton's method for y = ln F in the logarithm of the whole approach, which is almost straight.
double FaceLaw::force(double approach, double compliance, double relative_radius) const {
  if (approach <= 0.0) return 0.0;
  const double part = weight(relative_radius), wanted = std::log(approach);
  double y = curves_[0].approach.high;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double own = std::exp(log_approach(y, part)), spring = compliance * std::exp(y), both = own + spring;
    const double step = std::clamp((std::log(both) - wanted) * both / (own * power(y, part) + spring), -3.0, 3.0);
    y -= step;
    if (std::abs(step) <= 1e-14 * std::max(1.0, std::abs(y)) || y < -200.0) break;
  }
  return std::exp(y);
}

}  // namespace gearfilm

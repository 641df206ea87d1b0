// Hertz point contact (Johnson, Contact Mechanics, 1985, ch. 4), notation of doi 10.1016/j.triboint.2013.01.017.
//
// With m = 1-kappa^2 and S = (K-E)/(m K) the radius ratio is
//   D = kappa^2 (K-E)/(E - kappa^2 K) = kappa^2 S/(1-S).
// The first form is 0/0 for the circle; S is regular there (1/2) and the arithmetic-geometric mean gives it as
// a sum of positive terms (DLMF 19.8.6), so the second form keeps its digits for every kappa.
#include "contact/hertz.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

#include "contact/line_contact.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

namespace {

using std::numbers::pi;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// S = (K-E)/(m K) = sum over n >= 0 of 2^(n-1) c_n^2/m, with c_0^2 = m, c_1^2/m = (1-kappa)/(4 (1+kappa)) and
// c_(n+1) = c_n^2/(4 a_(n+1)), where a_n, g_n is the arithmetic-geometric mean of 1 and kappa.
double elliptic_defect(double kappa) {
  const double m = (1.0 - kappa) * (1.0 + kappa);
  double a = (1.0 + kappa) / 2.0;
  double g = std::sqrt(kappa);
  double term = (1.0 - kappa) / (4.0 * (1.0 + kappa));  // c_n^2/m
  double weight = 1.0;                                  // 2^(n-1)
  double sum = 0.5;
  while (weight * term > 0.1 * epsilon) {
    sum += weight * term;
    const double a_next = (a + g) / 2.0;
    g = std::sqrt(a * g);
    a = a_next;
    term *= term * m / (16.0 * a * a);
    weight *= 2.0;
  }
  return sum;
}

double radius_ratio_of(double kappa) {
  const double defect = elliptic_defect(kappa);
  return kappa * kappa * (defect / (1.0 - defect));
}

// kappa <= 1 for D < 1. The root is between D and sqrt(D), because 1 <= S/(1-S) <= 1/kappa. In logarithms the
// function is almost straight, so the Illinois variant of regula falsi takes a handful of steps.
double ellipticity_below_one(double radius_ratio) {
  const auto mismatch = [radius_ratio](double log_kappa) {
    return std::log(radius_ratio_of(std::exp(log_kappa)) / radius_ratio);
  };
  double low = std::log(radius_ratio);
  double high = low / 2.0;
  double at_low = mismatch(low);
  double at_high = mismatch(high);
  if (at_low >= 0.0) return std::exp(low);  // only by round-off, next to the circle
  if (at_high <= 0.0) return std::exp(high);
  int previous_side = 0;
  constexpr int most_steps = 100;
  for (int step = 0; step < most_steps; ++step) {
    const double x = (low * at_high - high * at_low) / (at_high - at_low);
    const double value = mismatch(x);
    const double reach = epsilon * (1.0 - x);
    if (value == 0.0 || x - low <= reach || high - x <= reach) return std::exp(x);
    const int side = value > 0.0 ? 1 : -1;
    if (side > 0) {
      high = x;
      at_high = value;
      if (previous_side == side) at_low /= 2.0;
    } else {
      low = x;
      at_low = value;
      if (previous_side == side) at_high /= 2.0;
    }
    previous_side = side;
  }
  return std::exp((low + high) / 2.0);
}

}  // namespace

double reduced_modulus(double youngs_modulus_1, double poisson_ratio_1, double youngs_modulus_2,
                       double poisson_ratio_2) {
  return 2.0 / ((1.0 - poisson_ratio_1 * poisson_ratio_1) / youngs_modulus_1 +
                (1.0 - poisson_ratio_2 * poisson_ratio_2) / youngs_modulus_2);
}

double hertz_ellipticity(double radius_ratio) {
  constexpr double smallest = 1e-6;
  if (!(radius_ratio >= smallest && radius_ratio <= 1.0 / smallest)) {
    std::ostringstream message;
    message << "radius ratio D = R_x/R_y = " << radius_ratio
            << " is outside [1e-6, 1e6]: not a point contact; give the flanks a crowning (pinion_crowning, "
               "wheel_crowning) that fits gear_face_width";
    throw InputError(message.str());
  }
  if (radius_ratio == 1.0) return 1.0;
  if (radius_ratio > 1.0) return 1.0 / ellipticity_below_one(1.0 / radius_ratio);
  return ellipticity_below_one(radius_ratio);
}

HertzContact hertz_contact(const ContactSolids& solids, double load) {
  assert(load > 0.0 && solids.reduced_modulus > 0.0);
  if (solids.line) return line_contact(solids, load);
  if (solids.face) return finite_line_contact(solids, load);
  HertzContact contact;
  contact.ellipticity = hertz_ellipticity(solids.radius_x / solids.radius_y);
  const bool exchanged = contact.ellipticity > 1.0;
  const double kappa = exchanged ? 1.0 / contact.ellipticity : contact.ellipticity;
  const double modulus = std::sqrt((1.0 - kappa) * (1.0 + kappa));
  const double K = std::comp_ellint_1(modulus);
  const double E = std::comp_ellint_2(modulus);
  const double R = solids.radius_x * solids.radius_y / (solids.radius_x + solids.radius_y);

  // b^3 = 6 E w R/(pi kappa^2 E'), a = kappa b
  contact.b = std::cbrt(6.0 * E * load * R / (pi * kappa * kappa * solids.reduced_modulus));
  contact.a = kappa * contact.b;
  if (exchanged) std::swap(contact.a, contact.b);
  contact.pressure = 3.0 * load / (2.0 * pi * contact.a * contact.b);
  // h_0n = K [9/(2 E R)]^(1/3) [w kappa/(pi E')]^(2/3)
  const double force_term = std::cbrt(load * kappa / (pi * solids.reduced_modulus));
  contact.approach = K * std::cbrt(9.0 / (2.0 * E * R)) * force_term * force_term;
  return contact;
}

double hertz_load(const ContactSolids& solids, double approach) {
  if (approach <= 0.0) return 0.0;
  // The approach grows as w^(2/3).
  const double ratio = approach / hertz_contact(solids, 1.0).approach;
  return ratio * std::sqrt(ratio);
}

// With y = F^(1/3) convex and increasing, so that Newton's method from above converges monotonically.
double force_on_spring(double unit_force, double compliance, double approach) {
  if (approach <= 0.0) return 0.0;
  if (compliance == 0.0) return unit_force * approach * std::sqrt(approach);
  const double root = std::cbrt(unit_force), q = 1.0 / (root * root);
  double y = std::sqrt(approach / q);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (q * y * y + compliance * y * y * y - approach) / (2.0 * q * y + 3.0 * compliance * y * y);
    y -= step;
    if (step <= 1e-15 * y) break;
  }
  return y * y * y;
}

double hertz_line_half_width(double load_per_length, double radius_x, double reduced_modulus) {
  return std::sqrt(8.0 * load_per_length * radius_x / (pi * reduced_modulus));
}

double equivalent_point_load(const ContactSolids& solids, double half_width) {
  assert(half_width > 0.0);
  // Both half-axes grow as w^(1/3).
  const double ratio = half_width / hertz_contact(solids, 1.0).a;
  return ratio * ratio * ratio;
}

}  // namespace gearfilm

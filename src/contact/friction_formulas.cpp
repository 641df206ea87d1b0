#include "contact/friction_formulas.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

double schlenk_friction(double line_load, double sum_velocity, double radius, double viscosity, double roughness) {
  return 0.048 * std::pow(1e-3 * line_load / (sum_velocity * 1e3 * radius), 0.2) * std::pow(1e3 * viscosity, -0.05) *
         std::pow(1e6 * roughness, 0.25);
}

double xu_kahraman_friction(double pressure, double slide_ratio, double entrainment_velocity, double viscosity,
                            double radius, double roughness) {
  const double P = 1e-9 * pressure, S = std::abs(slide_ratio), nu = 1e3 * viscosity;
  if (S == 0.0) return 0.0;
  const double group = S * P * std::log10(nu);
  const double f = -8.916465 - 0.354068 * group + 2.812084 * std::exp(-group) + 0.620305 * std::exp(1e6 * roughness);
  return std::exp(f) * std::pow(P, 1.03303) * std::pow(S, 1.036077) * std::pow(entrainment_velocity, -0.100601) *
         std::pow(nu, 0.752755) * std::pow(radius, -0.390958);
}

double blok_flash_temperature(double friction_load, double u_1, double u_2, double effusivity, double half_width) {
  constexpr double semi_ellipse = 1.11;
  return semi_ellipse * std::abs(friction_load * (std::sqrt(u_1) - std::sqrt(u_2))) /
         (effusivity * std::sqrt(2.0 * half_width));
}

double thermal_loading(double temperature_viscosity, double viscosity, double entrainment_velocity,
                       double conductivity) {
  return temperature_viscosity * viscosity * entrainment_velocity * entrainment_velocity / conductivity;
}

double murch_wilson_factor(double loading) { return 3.94 / (3.94 + std::pow(loading, 0.62)); }

double gupta_factor(double loading, double relative_pressure, double slide_ratio) {
  const double numerator = 1.0 - 13.2 * relative_pressure * std::pow(loading, 0.42);
  const double sliding = 1.0 + 2.23 * std::pow(std::abs(slide_ratio), 0.83);
  return std::max(0.0, numerator) / (1.0 + 0.213 * sliding * std::pow(loading, 0.64));
}

}  // namespace gearfilm

#include "rating/scuffing.hpp"

#include <cmath>

namespace gearfilm {
namespace {

constexpr double celsius_zero = 273.15;  // [K]

}  // namespace

double flash_temperature(double friction_load, double half_width, const HeatedSide& pinion, const HeatedSide& wheel) {
  return 1.11 * friction_load * std::abs(pinion.velocity - wheel.velocity) /
         (std::sqrt(2.0 * half_width) *
          (pinion.effusivity * std::sqrt(pinion.velocity) + wheel.effusivity * std::sqrt(wheel.velocity)));
}

double flash_safety(double scuffing_temperature, double oil_temperature, double largest_temperature) {
  return (scuffing_temperature - oil_temperature) / (largest_temperature - oil_temperature);
}

double integral_temperature(double bulk_temperature, double mean_flash_temperature) {
  constexpr double weight = 1.5;  // C_2
  return bulk_temperature + weight * mean_flash_temperature;
}

double integral_safety(double scuffing_temperature, double integral_temperature) {
  return (scuffing_temperature - celsius_zero) / (integral_temperature - celsius_zero);
}

}  // namespace gearfilm

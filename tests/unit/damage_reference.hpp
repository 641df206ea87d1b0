// The numbers of tests/reference/damage.json, and the stresses beneath a line contact in closed form.
#pragma once

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "stress/equivalent_stress.hpp"

namespace gearfilm {

inline const nlohmann::json& damage_reference() {
  static const nlohmann::json numbers =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/damage.json"));
  return numbers;
}

inline double damage_number(const std::string& name) { return damage_reference().at(name).at("value").get<double>(); }

/// Plane strain beneath a frictionless Hertz contact of half-width 1 and pressure 1 (McEwen; Johnson 1985, 4.49).
inline Stress line_contact_stress(double x, double z, double poisson_ratio = 0.3) {
  const double d = 1.0 - x * x + z * z, root = std::sqrt(d * d + 4.0 * x * x * z * z);
  const double m = std::sqrt(0.5 * (root + d)), n = std::copysign(std::sqrt(std::max(0.0, 0.5 * (root - d))), x);
  const double part = root > 0.0 ? (z * z + n * n) / (m * m + n * n) : 0.0;
  const double shear = root > 0.0 ? n * (m * m - z * z) / (m * m + n * n) : 0.0;
  const double xx = -(m * (1.0 + part) - 2.0 * z), zz = -m * (1.0 - part);
  return {.xx = xx, .yy = poisson_ratio * (xx + zz), .zz = zz, .xz = -shear};
}

}  // namespace gearfilm

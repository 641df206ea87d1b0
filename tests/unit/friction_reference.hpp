// What is expected of friction and heat in the case study: tests/reference/friction.json, with its tolerances.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace gearfilm::friction_case {

inline const nlohmann::json& reference() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/friction.json"));
  return all;
}

}  // namespace gearfilm::friction_case

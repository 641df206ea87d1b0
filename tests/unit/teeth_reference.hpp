// What is expected of the case study on real teeth: tests/reference/teeth.json, with its tolerances.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace gearfilm::teeth_case {

inline const nlohmann::json& reference() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/teeth.json"));
  return all;
}

}  // namespace gearfilm::teeth_case

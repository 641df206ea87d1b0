// The case study of the unit tests: Table 3 of doi 10.1016/j.triboint.2013.01.017, and access to the numbers
// expected of it (tests/reference/table3.json, with their tolerances).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "gearfilm/error.hpp"
#include "gear/gear_pair.hpp"

namespace gearfilm::table3 {

inline constexpr double pinion_speed = 15000.0 * 2.0 * std::numbers::pi / 60.0;  // [rad/s]
inline constexpr double pinion_torque = 470.0;                                   // [N m]
inline constexpr double equivalent_mass = 0.3709;                                // [kg]
inline constexpr double round_off = 1e-13;  // relative, of a few operations and powers

inline SpurGearPair gear_pair() {
  return {.pinion = {.teeth = 28, .outer_radius = 46.55e-3, .crowning = 0.131e-3},
          .wheel = {.teeth = 43, .outer_radius = 69.85e-3, .crowning = 0.131e-3},
          .module_length = 3e-3,
          .pressure_angle = 20.0 * std::numbers::pi / 180.0,
          .centre_distance = 111e-3,
          .face_width = 20e-3};
}

inline const nlohmann::json& reference() {
  static const nlohmann::json numbers =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/table3.json"));
  return numbers;
}

/// Compares with an entry of "derived", within the tolerance stated there.
inline void expect_derived(const std::string& name, double computed) {
  const auto& entry = reference().at("derived").at(name);
  const double expected = entry.at("value");
  const double tolerance = entry.at("rel_tol");
  EXPECT_NEAR(computed, expected, tolerance * std::abs(expected)) << name;
}

/// Message of the InputError that a call raises; empty (and a failure) when it raises none.
template <class Call>
std::string input_error_of(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

/// The message names what to change, on one line.
template <class Call>
void expect_input_error_naming(const std::string& parameter, Call&& call) {
  const std::string message = input_error_of(call);
  EXPECT_NE(message.find(parameter), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace gearfilm::table3

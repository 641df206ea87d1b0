// Drive trains of the tests, and the numbers expected of them (tests/reference/drivetrain.json, with tolerances).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "train/spur_row.hpp"
#include "train/train_damping.hpp"

namespace gearfilm::trains {

inline const nlohmann::json& reference() {
  static const nlohmann::json numbers =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/drivetrain.json"));
  return numbers;
}

inline const nlohmann::json& case_study() { return reference().at("table3").at("input"); }

inline double stiffness_of(const std::string& teeth) {
  return case_study().at(teeth == "rigid_teeth" ? "k_mesh_rigid" : "k_mesh_weber_bores");
}

/// A node of the case study's gears: 0 the pinion, 1 the wheel.
inline TrainNode gear_node(int gear, bool on_bearings) {
  TrainNode node{.name = gear == 0 ? "pinion" : "wheel",
                 .inertia = case_study().at("I")[gear],
                 .radius = case_study().at("rb")[gear]};
  if (on_bearings) node.mass = case_study().at("m")[gear];
  return node;
}

/// The contact of the nodes pinion and wheel.
inline void mesh_gears(Train& train, double pressure_angle = case_study().at("alpha_w_rad")) {
  const std::size_t pinion = *train.find("pinion"), wheel = *train.find("wheel");
  train.add_contact(
      spur_row(train, {pinion, train.node(pinion).radius}, {wheel, train.node(wheel).radius}, pressure_angle));
}

inline Bearing bearing_of(double x, double y) { return {.stiffness = Eigen::Vector2d(x, y).asDiagonal()}; }

/// The case study on bearings of one stiffness.
inline Train pair_on_bearings(double stiffness, double pressure_angle = case_study().at("alpha_w_rad")) {
  Train train({gear_node(0, true), gear_node(1, true)});
  train.add_bearing(0, bearing_of(stiffness, stiffness));
  train.add_bearing(1, bearing_of(stiffness, stiffness));
  mesh_gears(train, pressure_angle);
  return train;
}

/// motor 0.02 - pinion, wheel - load 0.15; the first node may have an imposed speed.
inline Train line_with_motor_and_load(bool on_bearings, bool fixed = false) {
  Train train({{.name = "motor", .inertia = 0.02, .radius = case_study().at("rb")[0], .fixed = fixed},
               gear_node(0, on_bearings),
               gear_node(1, on_bearings),
               {.name = "load", .inertia = 0.15, .radius = case_study().at("rb")[1]}});
  train.add_shaft(0, 1, {.stiffness = 2e4});
  train.add_shaft(2, 3, {.stiffness = 8e4});
  mesh_gears(train);
  return train;
}

inline std::vector<TrainMode> modes_of(const Train& train, const std::vector<double>& stiffness) {
  return train_modes(train, relative_motion(train), stiffness);
}

/// expected: all frequencies in order, the rotation of the whole first if there is one.
inline void expect_frequencies(const std::vector<TrainMode>& modes, const nlohmann::json& expected, double relative,
                               double absolute = 0.0) {
  const std::size_t rigid = expected.at(0).get<double>() == 0.0 ? 1 : 0;
  ASSERT_EQ(modes.size() + rigid, expected.size());
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const double frequency = expected.at(n + rigid);
    EXPECT_NEAR(modes[n].frequency(), frequency, relative * frequency + absolute) << "mode " << n + 1;
  }
}

}  // namespace gearfilm::trains

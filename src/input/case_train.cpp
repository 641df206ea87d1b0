#include "input/case_train.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "input/case.hpp"
#include "input/case_setup.hpp"
#include "input/plain_text.hpp"
#include "input/train_torques.hpp"
#include "train/spur_row.hpp"

namespace gearfilm {
namespace {

const std::string run_up_key = "ramp.inertia_torque";

void require_inertias(const ParameterValues& values, const std::string& key) {
  const std::string mass = "gear.equivalent_mass";
  if (values.has(mass)) {
    values.refuse(mass, "is given beside " + in_quotes(key) +
                            " of a drive train, which needs more than one mass; give pinion.inertia and "
                            "wheel.inertia in its place");
  }
  for (const std::string inertia : {"pinion.inertia", "wheel.inertia"}) {
    if (values.has(inertia)) continue;
    values.refuse(key,
                  "is given, but " + in_quotes(inertia) + " is not; a drive train needs the inertias of both gears");
  }
}

void add_gears(const ParameterValues& values, const LineOfAction& line, TrainParts& parts) {
  const auto node = [&](const std::string& gear, double radius) {
    return TrainNode{.name = gear, .inertia = values.real(gear + ".inertia"), .radius = radius};
  };
  parts.nodes = {node("pinion", line.base_radius_pinion()), node("wheel", line.base_radius_wheel())};
  parts.sides = {TrainSide::pinion, TrainSide::wheel};
  for (const std::size_t gear : {TrainParts::pinion, TrainParts::wheel}) {
    add_gear_bearings(values, gear, parts);
  }
}

/// The motor on the pinion's side, the load on the wheel's.
void add_machine(const ParameterValues& values, const std::string& machine, std::size_t gear, TrainParts& parts) {
  const std::string inertia = machine + ".inertia", stiffness = machine + ".shaft_stiffness";
  const std::string damping = machine + ".shaft_damping", fixed = machine + ".fixed";
  const bool held = values.has(fixed) && values.yes(fixed);
  if (!values.has(inertia) && !held) {
    for (const std::string& key : {stiffness, damping}) {
      if (values.has(key)) values.refuse(key, "is given, but nothing is on the shaft; give " + in_quotes(inertia));
    }
    return;
  }
  if (!values.has(stiffness)) {
    values.refuse(values.has(inertia) ? inertia : fixed,
                  "is given, but not " + in_quotes(stiffness) + "; give the shaft to the " + parts.nodes[gear].name);
  }
  parts.nodes.push_back({.name = machine,
                         .inertia = values.real_if_given(inertia).value_or(0.0),
                         .radius = parts.nodes[gear].radius,
                         .fixed = held});
  parts.sides.push_back(parts.sides[gear]);
  parts.shafts.push_back(
      {parts.nodes.size() - 1,
       gear,
       {.stiffness = values.real(stiffness), .damping = values.real_if_given(damping).value_or(0.0)}});
}

/// Gears move where they have bearings.
void set_masses(const ParameterValues& values, TrainParts& parts) {
  for (const std::size_t gear : {TrainParts::pinion, TrainParts::wheel}) {
    TrainNode& node = parts.nodes[gear];
    const std::string mass = node.name + ".mass";
    const bool held = std::ranges::find(parts.bearings, gear, &TrainParts::BearingPart::node) != parts.bearings.end();
    if (held) {
      const double disc = 2.0 * node.inertia / (node.radius * node.radius);
      node.mass = values.real_if_given(mass).value_or(disc);
    } else if (values.has(mass)) {
      values.refuse(mass, "is given, but the gear has no bearings to move on; give '" + node.name +
                              ".bearing_stiffness', or delete it");
    }
  }
}

TrainCase put_together(const TrainParts& parts, const LineOfAction& line, double damping_ratio) {
  Train train(parts.nodes);
  for (const auto& [a, b, shaft] : parts.shafts) train.add_shaft(a, b, shaft);
  for (const auto& [node, bearing] : parts.bearings) train.add_bearing(node, bearing);
  for (const auto& [node, stiffness, damping] : parts.grounds) train.add_ground(node, stiffness, damping);
  const SpurGearNode pinion{TrainParts::pinion, line.base_radius_pinion()};
  const SpurGearNode wheel{TrainParts::wheel, line.base_radius_wheel()};
  train.add_contact(spur_row(train, pinion, wheel, line.working_pressure_angle()));
  Eigen::RowVectorXd back = spur_back_row(train, pinion, wheel, line.working_pressure_angle());
  Eigen::MatrixXd friction = spur_friction_rows(train, pinion, wheel, line.working_pressure_angle());
  return {.train = std::move(train),
          .back = std::move(back),
          .friction = std::move(friction),
          .damping_ratio = damping_ratio,
          .two_bearings = parts.two_bearings};
}

}  // namespace

bool is_train_key(const std::string& key) {
  const std::size_t dot = key.find('.');
  const std::string section = key.substr(0, dot);
  if (section == "motor" || section == "load" || section == "train") return true;
  return key == run_up_key || key.find(".bearing_") != std::string::npos ||
         (dot != std::string::npos && key.substr(dot) == ".mass");
}

std::string given_train_key(const ParameterValues& values) {
  for (const Parameter& parameter : parameter_table()) {
    if (!is_train_key(parameter.name) || !values.given(parameter.name)) continue;
    // That a machine is not held, or that a run-up loads no tooth, makes no train.
    const bool asks = parameter.name.ends_with(".fixed") || parameter.name == run_up_key;
    if (asks && !values.yes(parameter.name)) continue;
    return parameter.name;
  }
  return {};
}

std::optional<TrainCase> read_train(const ParameterValues& values, const LineOfAction& line) {
  const std::string key = given_train_key(values), compliance = "gear.mesh_compliance";
  if (key.empty()) return {};
  require_inertias(values, key);
  TrainParts parts;
  add_gears(values, line, parts);
  add_machine(values, "motor", TrainParts::pinion, parts);
  add_machine(values, "load", TrainParts::wheel, parts);
  if (values.has("train.file")) add_train_file(values, parts);
  set_masses(values, parts);
  complete_torques(values, line, parts);
  if (!parts.bearings.empty() && values.real(compliance) > 0.0) {
    values.refuse(compliance, "is " + format_value(values.real(compliance)) +
                                  " m/N beside bearings of a drive train, which would be counted twice; delete it");
  }
  TrainCase found = put_together(parts, line, values.real_if_given("train.damping_ratio").value_or(0.0));
  in_file_of(values, [&] { return relative_motion(found.train); });
  set_torques(values, line, parts, found);
  return found;
}

namespace {

/// Bodies in balance have no inertia that would take a part of a torque.
void require_constant_torques(const CaseInput& problem, const std::string& command) {
  const ParameterValues& values = problem.parameters;
  const std::string how = problem.march.motion == PairMotion::quasi_static ? "motion" : "model";
  const std::string in_balance = "with '" + how + ": " + values.text(how) + "' bodies are in balance at every moment";
  if (!problem.pair.train->pattern.given_by.empty()) {
    throw InputError(problem.pair.train->pattern.given_by + "fluctuates, but " + in_balance + " in " + command +
                     ", and none takes its part of it; set " + how + " to dynamic, or give a constant torque");
  }
  if (values.yes(run_up_key)) {
    values.refuse(run_up_key, "is yes, but " + in_balance + " without inertia; set " + how + " to dynamic");
  }
}

}  // namespace

void require_moving_train(const CaseInput& problem, const std::string& command) {
  if (!problem.pair.train) return;
  const ParameterValues& values = problem.parameters;
  if (problem.march.model == MarchModel::quasistatic || problem.march.motion == PairMotion::quasi_static) {
    require_constant_torques(problem, command);
  }
  if (torque_determines_force(problem.pair.train->train)) return;
  in_file_of(values, []() {
    throw InputError(
        "the drive train holds both the pinion's side and the wheel's, so that the torque does not determine the tooth "
        "force; free one side (fixed, ground)");
  });
}

namespace {

/// k_el [N/m].
double mesh_stiffness(const CaseInput& problem) {
  return problem.scales.force(problem.pair.stiffness) / problem.scales.thickness;
}

}  // namespace

DampedTrain damped_train_of(const CaseInput& problem) {
  ContactSpring contact{.stiffness = mesh_stiffness(problem)};
  if (problem.dry()) {
    const double zeta = problem.march.dry_damping_ratio.value_or(0.0);
    contact.damping = 2.0 * zeta * std::sqrt(contact.stiffness * *problem.pair.equivalent_mass);
  }
  return damped_train(problem.pair.train->train, contact, problem.pair.train->damping_ratio);
}

std::shared_ptr<const MeshTrain> mesh_train_of(const CaseInput& problem) {
  if (!problem.pair.train || !torque_determines_force(problem.pair.train->train)) return {};
  const TrainCase& given = *problem.pair.train;
  FlankRows rows;
  if (problem.pair.teeth.backlash()) rows.back = given.back;
  if (problem.parameters.yes("friction.in_motion")) rows.friction = given.friction;
  const auto damped = std::make_shared<const DampedTrain>(
      damped_train(given.train, {.stiffness = mesh_stiffness(problem)}, given.damping_ratio));
  return std::make_shared<const MeshTrain>(
      mesh_train(damped, rows, given.torques, problem.scales, problem.pair.pinion_speed));
}

long whole_pattern(const CaseInput& problem) {
  const long teeth = problem.pair.teeth.pattern();
  return problem.pair.train ? std::lcm(teeth, problem.pair.train->pattern.periods.value_or(1)) : teeth;
}

double centre_distance_growth(const CaseInput& problem) {
  const Train& train = problem.pair.train->train;
  const Eigen::VectorXd force = problem.pair.tooth_force * train.contacts().row(0).transpose();
  double growth = 0.0;
  for (const std::size_t gear : {TrainParts::pinion, TrainParts::wheel}) {
    if (!train.node(gear).mass) continue;
    const Eigen::MatrixXd u = train.translation(gear);
    const Eigen::Matrix2d held = u * train.stiffness() * u.transpose();
    const Eigen::Vector2d way = held.inverse() * (u * force);
    growth += gear == TrainParts::wheel ? way.x() : -way.x();
  }
  return growth;
}

}  // namespace gearfilm

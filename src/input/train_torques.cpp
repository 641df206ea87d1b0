// Torques of a drive train, constant and fluctuating (train_parts.hpp).
#include "input/train_torques.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

#include "gearfilm/error.hpp"

namespace gearfilm {

std::optional<WrittenHarmonic> read_harmonic(const std::string& words) {
  std::istringstream stream(words);
  WrittenHarmonic one;
  std::string order, more;
  if (!(stream >> order >> one.amplitude >> one.degrees) || stream >> more) return {};
  one.fixed = order.ends_with("Hz");
  if (one.fixed) order.resize(order.size() - 2);
  std::istringstream number(order);
  const bool valid = number >> one.order && !(number >> more) && one.order > 0.0 && std::isfinite(one.order) &&
                     std::isfinite(one.amplitude) && std::abs(one.degrees) <= 360.0;
  return valid ? std::optional(one) : std::nullopt;
}

namespace {

constexpr long finest_order = 64;          // denominator of an order
constexpr long longest_pattern = 1000000;  // mesh periods, after which a fixed frequency counts as never repeating
constexpr double largest_swing = 0.01;     // of the whole train, over the base pitch
constexpr double balanced = 1e-6;          // of torques that add up to another

[[noreturn]] void refuse(const TorquePart& torque, const std::string& what) { throw InputError(torque.origin + what); }

/// Speeds and what fluctuates, for one torque.
struct Fluctuation {
  const TorquePart& torque;
  double mesh_frequency;  ///< [Hz]
  int teeth;              ///< of the gear on its side

  double cycles(const WrittenHarmonic& one) const { return one.fixed ? one.order / mesh_frequency : one.order / teeth; }

  /// Mesh periods after which it repeats; nothing of a fixed frequency that never does.
  std::optional<long> periods(const WrittenHarmonic& one) const {
    if (one.fixed) {
      for (long count = 1; count <= longest_pattern; ++count) {
        const double turns = cycles(one) * static_cast<double>(count);
        if (std::abs(turns - std::round(turns)) <= 1e-9 * static_cast<double>(count)) return count;
      }
      return {};
    }
    for (long denominator = 1; denominator <= finest_order; ++denominator) {
      const double turns = one.order * static_cast<double>(denominator);
      if (std::abs(turns - std::round(turns)) > 1e-9 * turns) continue;
      return denominator * teeth / std::gcd(std::lround(turns), denominator * teeth);
    }
    refuse(torque, "has the order " + format_value(one.order) +
                       ", which never repeats together with the mesh; give a whole number or a fraction of at most " +
                       std::to_string(finest_order) + "ths");
  }
};

/// Where the whole turns freely its speed swings by the torque; contacts are where the mean speed brings them.
void check_swing(const Fluctuation& of, const WrittenHarmonic& one, const LineOfAction& line, const Train& train) {
  const Eigen::VectorXd rigid = relative_motion(train).rigid;
  if (rigid.size() == 0) return;
  const double omega = 2.0 * std::numbers::pi * of.cycles(one) * of.mesh_frequency;
  const double turn = train.rotation(of.torque.node).dot(rigid) * of.torque.mean * one.amplitude /
                      (rigid.dot(train.mass() * rigid) * omega * omega);
  const double way = std::abs(turn * train.rotation(TrainParts::pinion).dot(rigid)) * line.base_radius_pinion();
  if (way <= largest_swing * line.base_pitch()) return;
  refuse(of.torque, "swings the whole train by " + format_value(way) + " m at " +
                        (one.fixed ? format_value(one.order) + " Hz" : "the order " + format_value(one.order)) +
                        ", more than " + format_value(largest_swing) +
                        " of the base pitch: contacts would not be where they are computed; lower its amplitude, or "
                        "give the inertias of motor and load");
}

void add_to_pattern(const Fluctuation& of, const WrittenHarmonic& one, TorquePattern& pattern) {
  const std::optional<long> periods = of.periods(one);
  pattern.given_by = of.torque.origin;
  if (one.fixed) pattern.fixed = one.order;
  if (pattern.periods && periods) {
    pattern.periods = std::lcm(*pattern.periods, *periods);
  } else {
    pattern.periods.reset();
  }
}

/// Whether the ground takes what torques on a side do not balance.
bool is_held(const TrainParts& parts, TrainSide side) {
  const bool grounded = std::ranges::any_of(
      parts.grounds, [&](const TrainParts::GroundPart& ground) { return parts.sides[ground.node] == side; });
  for (std::size_t n = 0; n < parts.nodes.size(); ++n) {
    if (parts.sides[n] == side && parts.nodes[n].fixed) return true;
  }
  return grounded;
}

/// Of a machine's key.
void add_machine_torque(const ParameterValues& values, const std::string& machine, std::size_t gear, double mean,
                        TrainParts& parts) {
  const std::string key = machine + ".torque_harmonics";
  if (!values.has(key)) return;
  const auto found = std::ranges::find(parts.nodes, machine, &TrainNode::name);
  const bool there = found != parts.nodes.end();
  if (there && found->fixed) {
    values.refuse(key, "is given, but the " + machine + " turns at an imposed speed; delete one");
  }
  for (const TorquePart& torque : parts.torques) {
    if (parts.sides[torque.node] == parts.sides[gear]) {
      values.refuse(key, "is given beside 'torque' lines of that side in 'train.file'; write it there");
    }
  }
  TorquePart torque{.node = there ? static_cast<std::size_t>(found - parts.nodes.begin()) : gear,
                    .mean = mean,
                    .origin = values.origin(key) + ": '" + key + "' "};
  std::istringstream stream(values.text(key));
  for (std::string part; std::getline(stream, part, ',');) {
    const auto harmonic = read_harmonic(part);
    if (!harmonic) {
      values.refuse(key, "has the part '" + part +
                             "', which is no order > 0 or frequency as 300Hz, amplitude and phase in degrees; separate "
                             "parts by commas, as in 1 0.1 0, 6 0.02 30");
    }
    torque.harmonics.push_back(*harmonic);
  }
  parts.torques.push_back(std::move(torque));
}

/// The torques on a side, all of which together are as given; a machine takes that where none are.
void complete_side(TrainParts& parts, TrainSide side, double whole) {
  const std::string name = side == TrainSide::pinion ? "pinion" : "wheel";
  double sum = 0.0;
  const TorquePart* last = nullptr;
  for (const TorquePart& torque : parts.torques) {
    if (parts.sides[torque.node] != side) continue;
    sum += torque.mean;
    last = &torque;
  }
  if (!last) {
    const std::string machine = side == TrainSide::pinion ? "motor" : "load";
    const auto found = std::ranges::find(parts.nodes, machine, &TrainNode::name);
    const std::size_t gear = side == TrainSide::pinion ? TrainParts::pinion : TrainParts::wheel;
    const bool there = found != parts.nodes.end();
    parts.torques.push_back(
        {.node = there ? static_cast<std::size_t>(found - parts.nodes.begin()) : gear, .mean = whole});
    return;
  }
  if (is_held(parts, side) || std::abs(sum - whole) <= balanced * std::abs(whole)) return;
  refuse(*last, "on '" + parts.nodes[last->node].name + "' makes " + format_value(sum) + " N m of all torques on the " +
                    name + "'s side, which do not balance pinion.torque; give " +
                    format_value(last->mean + whole - sum) + " N m here, so that they are " + format_value(whole));
}

}  // namespace

void complete_torques(const ParameterValues& values, const LineOfAction& line, TrainParts& parts) {
  const double driving = values.real("pinion.torque");
  const double load = -driving * line.base_radius_wheel() / line.base_radius_pinion();
  add_machine_torque(values, "motor", TrainParts::pinion, driving, parts);
  add_machine_torque(values, "load", TrainParts::wheel, load, parts);
  complete_side(parts, TrainSide::pinion, driving);
  complete_side(parts, TrainSide::wheel, load);
}

void set_torques(const ParameterValues& values, const LineOfAction& line, const TrainParts& parts, TrainCase& train) {
  const double mesh_frequency = values.real("pinion.speed_rpm") / 60.0 * values.integer("pinion.teeth");
  const std::string run_up = "ramp.inertia_torque";
  const bool loads_teeth = values.yes(run_up);
  if (loads_teeth && !values.has("ramp.to_rpm")) {
    values.refuse(run_up, "is yes, but no speed is run up to; give ramp.to_rpm");
  }
  if (loads_teeth && relative_motion(train.train).rigid.size() == 0) {
    values.refuse(run_up,
                  "is yes, but the drive train does not turn freely, so that no load follows from its "
                  "acceleration; delete fixed and ground, or this key");
  }
  for (const TorquePart& torque : parts.torques) {
    const bool pinion = parts.sides[torque.node] == TrainSide::pinion;
    const Fluctuation fluctuation{torque, mesh_frequency, values.integer(pinion ? "pinion.teeth" : "wheel.teeth")};
    NodeTorque set{.node = train.train.rotation(torque.node), .mean = torque.mean};
    for (const WrittenHarmonic& one : torque.harmonics) {
      check_swing(fluctuation, one, line, train.train);
      add_to_pattern(fluctuation, one, train.pattern);
      set.harmonics.push_back({fluctuation.cycles(one), one.amplitude, one.degrees * std::numbers::pi / 180.0});
    }
    train.torques.push_back(std::move(set));
  }
  // The last torque of the wheel's side gives way.
  if (!loads_teeth) return;
  std::size_t load = 0;
  for (std::size_t n = 0; n < parts.torques.size(); ++n) {
    if (parts.sides[parts.torques[n].node] == TrainSide::wheel) load = n;
  }
  train.torques[load].accelerates = true;
}

}  // namespace gearfilm

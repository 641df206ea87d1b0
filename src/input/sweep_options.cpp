#include "input/sweep_options.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "gearfilm/error.hpp"
#include "input/case_train.hpp"

namespace gearfilm {
namespace {

const std::map<std::string, std::string>& sweep_keys() {
  static const std::map<std::string, std::string> by_choice = {
      {"speed", "pinion.speed_rpm"}, {"torque", "pinion.torque"}, {"equivalent_mass", "gear.equivalent_mass"}};
  return by_choice;
}

/// The key that is varied.
std::string read_key(const ParameterValues& values) {
  const std::string& over = values.text("sweep.over");
  if (const auto known = sweep_keys().find(over); known != sweep_keys().end()) return known->second;
  const Parameter* parameter = find_parameter(over);
  if (parameter && parameter->type == ParameterType::real && (is_train_key(over) || over.ends_with(".inertia")))
    return over;
  values.refuse("sweep.over",
                "is " + over +
                    "; give speed, torque, equivalent_mass, or a key of the drive train that has a number, "
                    "as motor.inertia or pinion.bearing_stiffness");
}

/// Numbers between commas or spaces.
std::vector<double> read_list(const ParameterValues& values, const Parameter& varied) {
  const std::string name = "sweep.values";
  const std::string& origin = values.origin(name);
  std::string text = values.text(name);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<double> list;
  for (std::string word; words >> word;) {
    list.push_back(std::get<double>(parse_value(varied, word, origin + ": 'sweep.values'")));
  }
  if (list.empty()) throw InputError(origin + ": 'sweep.values' has no number; give some, '8000, 9000'");
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::vector<double> read_range(const ParameterValues& values, const Parameter& varied) {
  for (const std::string name : {"sweep.from", "sweep.to"}) {
    parse_value(varied, format_value(values.real(name)), values.origin(name) + ": '" + name + "'");
  }
  const double from = values.real("sweep.from"), to = values.real("sweep.to");
  const int points = values.integer("sweep.points");
  if (!(from < to)) {
    values.refuse("sweep.from", "is " + format_value(from) + ", not below 'sweep.to', " + format_value(to) +
                                    "; give the smaller value first (sweep.direction says which way to go)");
  }
  std::vector<double> list;
  list.reserve(points);
  for (int n = 0; n < points; ++n) list.push_back(from + (to - from) * n / (points - 1));
  return list;
}

/// Starts of basins, row by row of H_0.
std::vector<Motion> read_starts(const ParameterValues& values) {
  const auto range = [&](const std::string& of) {
    const std::string first = "sweep." + of + "_from", last = "sweep." + of + "_to";
    for (const std::string& name : {first, last}) {
      if (values.has(name)) continue;
      throw InputError("'" + name + "' is missing, but sweep.kind is basins; give the range of starts: " + first +
                       " and " + last);
    }
    const double from = values.real(first), to = values.real(last);
    if (from < to) return std::pair{from, to};
    values.refuse(first, "is " + format_value(from) + ", not below '" + last + "', " + format_value(to) +
                             "; give the smaller value first");
  };
  const auto [H0_from, H0_to] = range("H0");
  const auto [V0_from, V0_to] = range("V0");
  const int count = values.integer("sweep.starts");
  std::vector<Motion> starts;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      starts.emplace_back(H0_from + (H0_to - H0_from) * i / (count - 1), V0_from + (V0_to - V0_from) * j / (count - 1));
    }
  }
  return starts;
}

}  // namespace

SweepOptions read_sweep(const ParameterValues& values) {
  SweepOptions sweep;
  const std::string& kind = values.text("sweep.kind");
  sweep.march_periods = values.integer("sweep.march_periods");
  sweep.kept_periods = values.integer("sweep.kept_periods");
  sweep.groups = values.integer("sweep.groups");
  if (kind == "basins") {
    sweep.kind = SweepKind::basins;
    sweep.unit = "(number of the start)";
    sweep.down = false;
    sweep.chain_points = 1;
    sweep.starts = read_starts(values);
    for (std::size_t n = 0; n < sweep.starts.size(); ++n) sweep.values.push_back(static_cast<double>(n));
    return sweep;
  }
  if (kind == "marches") sweep.kind = SweepKind::marches;
  sweep.parameter = read_key(values);
  const Parameter& varied = *find_parameter(sweep.parameter);
  sweep.unit = varied.unit;
  values.require_both("sweep.from", "sweep.to", "give both ends");
  values.require_not_both("sweep.values", "sweep.from", "; delete the list or the range");
  if (values.has("sweep.values")) sweep.values = read_list(values, varied);
  if (values.has("sweep.from")) sweep.values = read_range(values, varied);
  const std::string& direction = values.text("sweep.direction");
  sweep.up = direction != "down";
  sweep.down = direction != "up";
  // Bodies in balance remember nothing that a neighbour could tell.
  const bool in_balance = values.text("motion") == "quasi_static";
  sweep.chain_points = in_balance ? 1 : values.integer("sweep.chain_points");
  return sweep;
}

}  // namespace gearfilm

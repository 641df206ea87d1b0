#include "input/continuation_options.hpp"

#include <algorithm>
#include <map>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

const std::map<std::string, std::string>& continuation_keys() {
  static const std::map<std::string, std::string> by_choice = {{"speed", "pinion.speed_rpm"},
                                                               {"torque", "pinion.torque"},
                                                               {"mass", "gear.equivalent_mass"},
                                                               {"viscosity", "lubricant.viscosity"}};
  return by_choice;
}

void read_ends(const ParameterValues& values, ContinuationCase& result) {
  const std::string from = "continuation.from", to = "continuation.to";
  values.require_both(from, to, "give both ends");
  if (!values.has(from)) return;
  for (const std::string& name : {from, to}) {
    parse_value(*find_parameter(result.parameter), format_value(values.real(name)),
                values.origin(name) + ": '" + name + "'");
  }
  result.from = values.real(from);
  result.to = values.real(to);
  if (*result.from == result.to) {
    throw InputError(values.origin(to) + ": 'continuation.to' is " + format_value(result.to) +
                     ", and so is 'continuation.from'; give another end, above or below");
  }
}

struct Step {
  const char* name;
  double ContinuationOptions::*member;
};

constexpr Step first_step = {"continuation.first_step", &ContinuationOptions::first_step};
constexpr Step smallest_step = {"continuation.smallest_step", &ContinuationOptions::smallest_step};
constexpr Step largest_step = {"continuation.largest_step", &ContinuationOptions::largest_step};
constexpr Step tolerance = {"continuation.tolerance", &ContinuationOptions::located};

/// The name of one that is given, of two that do not fit together.
std::string given_of(const ParameterValues& values, const Step& one, const Step& other) {
  return values.has(one.name) ? one.name : other.name;
}

void require_ascending(const ParameterValues& values, const ContinuationOptions& options, const Step& smaller,
                       const Step& larger) {
  const double small = options.*smaller.member, large = options.*larger.member;
  if (small <= large) return;
  throw InputError(values.origin(given_of(values, smaller, larger)) + ": '" + smaller.name + "' is " +
                   format_value(small) + ", above '" + larger.name + "', " + format_value(large) +
                   "; lower it or raise the other");
}

}  // namespace

ContinuationOptions continuation_steps(bool on_films) {
  ContinuationOptions options;
  if (!on_films) return options;
  options.first_step = 0.1;
  options.smallest_step = 2e-3;
  options.largest_step = 0.5;
  options.located = 0.02;
  return options;
}

ContinuationCase read_continuation(const ParameterValues& values, int order) {
  constexpr double parts = 10.0;  // of the range; one counts as much as 1 of H_0 and V_0
  const bool on_films = values.text("model") != "dry";
  ContinuationCase result;
  result.parameter = continuation_keys().at(values.text("continuation.parameter"));
  result.unit = find_parameter(result.parameter)->unit;
  result.options = continuation_steps(on_films);
  read_ends(values, result);
  ContinuationOptions& options = result.options;
  for (const Step& step : {first_step, smallest_step, largest_step, tolerance}) {
    if (values.has(step.name)) options.*step.member = values.real(step.name);
  }
  require_ascending(values, options, smallest_step, first_step);
  require_ascending(values, options, first_step, largest_step);
  if (result.from) {
    options.lowest = std::min(*result.from, result.to);
    options.highest = std::max(*result.from, result.to);
    options.corrector.unit = (options.highest - options.lowest) / parts;
  }
  // Dry motions are integrated to 1e-10 a step, and known to some 1e-9 where the pair swings often in a period.
  constexpr double dry_tolerance = 2e-8;
  options.corrector.tolerance = on_films ? values.real("periodic.tolerance") : dry_tolerance;
  options.most_points = values.integer("continuation.points");
  const bool follow = values.yes("continuation.follow_flips");
  options.largest_order = follow ? values.integer("continuation.largest_order") : order;
  return result;
}

}  // namespace gearfilm

// How the records of the parameter table are written: one record a line, sections around them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "input/parameter.hpp"

namespace gearfilm {

using Records = std::vector<Parameter>;
using Words = std::vector<std::string>;

inline Range at_least(double lower) { return {.lower = lower}; }
inline Range closed(double lower, double upper) { return {.lower = lower, .upper = upper}; }
inline Range left_open(double lower, double upper) { return {.lower = lower, .upper = upper, .lower_open = true}; }
inline Range right_open(double lower, double upper) { return {.lower = lower, .upper = upper, .upper_open = true}; }
inline Range odd(double lower, double upper) { return {.lower = lower, .upper = upper, .odd = true}; }

// One record; section() puts the section before the name, and before a former one.
inline Parameter number(std::string name, std::string symbol, std::string unit, const Range& range,
                        std::string meaning) {
  return {.name = std::move(name),
          .symbol = std::move(symbol),
          .unit = std::move(unit),
          .range = range,
          .meaning = std::move(meaning)};
}

inline Parameter whole(std::string name, std::string symbol, const Range& range, std::string meaning) {
  Parameter parameter = number(std::move(name), std::move(symbol), "-", range, std::move(meaning));
  parameter.type = ParameterType::integer;
  return parameter;
}

inline Parameter word(std::string name, std::string meaning) {
  return {.name = std::move(name), .type = ParameterType::text, .meaning = std::move(meaning)};
}

// The first choice is the default.
inline Parameter choice(std::string name, Words choices, std::string meaning) {
  Parameter parameter = word(std::move(name), std::move(meaning));
  parameter.type = ParameterType::choice;
  parameter.presence = Presence::preset;
  parameter.fallback = choices.front();
  parameter.choices = std::move(choices);
  return parameter;
}

inline Parameter preset(const ParameterValue& value, Parameter parameter) {
  parameter.presence = Presence::preset;
  parameter.fallback = format_value(value);
  return parameter;
}

inline Parameter optional(std::string when_absent, Parameter parameter) {
  parameter.presence = Presence::optional;
  parameter.fallback = std::move(when_absent);
  return parameter;
}

// Words of which an option alone, without a value, means the second.
inline Parameter flag(std::string name, std::string meaning) {
  Parameter parameter = choice(std::move(name), {"no", "yes"}, std::move(meaning));
  parameter.implied = "yes";
  return parameter;
}

// Keys of the top level have no section: name is empty.
inline Records section(const std::string& name, Scope scope, Records records) {
  for (Parameter& parameter : records) {
    if (!name.empty()) parameter.name = name + "." + parameter.name;
    if (!name.empty() && !parameter.former.empty()) parameter.former = name + "." + parameter.former;
    parameter.scope = scope;
  }
  return records;
}

/// A key that had another name.
inline Parameter former(std::string name, Parameter parameter) {
  parameter.former = std::move(name);
  return parameter;
}

/// Relief of a flank at both ends of its face, or of the gap of two; and what the solids have at the ends.
std::vector<Parameter> end_relief_records(const std::string& of_what);
std::vector<Parameter> end_face_records();
/// The flank of one gear along the face.
std::vector<Parameter> lead_records();
/// Sections pinion, wheel and gear.
std::vector<Parameter> gear_pair_records();
/// Section lubricant.
std::vector<Parameter> lubricant_records();
/// Sections friction and thermal; and what heat needs of a body, as part of the section that has it.
std::vector<Parameter> traction_records();
std::vector<Parameter> heated_body_records(const std::string& subscript, const std::string& ending = "");

/// Sections roughness and wear; and the roughness of a body and its lay, as parts of the sections that have them.
std::vector<Parameter> roughness_records();
std::vector<Parameter> roughness_of_body_records(const std::string& subscript, const std::string& ending = "");
std::vector<Parameter> lay_records();
std::vector<Parameter> surface_record();

/// Sections stress and fatigue; and what is known of a flank's strength, as part of its gear's section.
std::vector<Parameter> stress_records();
std::vector<Parameter> fatigue_records();
std::vector<Parameter> flank_material_records(const std::string& subscript);

/// Section rating.
std::vector<Parameter> rating_records();

/// Sections motor, load and train; and mass and bearings of a gear, as part of its section.
std::vector<Parameter> train_records();
std::vector<Parameter> supports_of_gear_records(const std::string& subscript);

/// All in one list.
template <class... More>
Records joined(Records first, const More&... more) {
  (first.insert(first.end(), more.begin(), more.end()), ...);
  return first;
}

}  // namespace gearfilm

// The table of everything a user can set, one record a parameter.
//
// The key in a case file is the record's name ("pinion.teeth", written nested or dotted), the option on the command
// line the same with underscores ("-pinion_teeth"). Help, docs/parameters.md, the echo in the results and every
// type, range and unknown-name error are made from these records.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gearfilm {

enum class ParameterType { integer, real, choice, text };

/// The kind of case a parameter belongs to.
enum class Scope { any, gear_pair, contact, line, bare };  // bare: contact or line

/// required: in the scope, must be given. preset: has a default value. optional: may be absent.
enum class Presence { required, preset, optional };

/// Allowed interval of a number; an open end is not allowed itself.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;
  bool odd = false;  ///< whole numbers only: even ones are not allowed

  bool contains(double value) const;
};

struct Parameter {
  std::string name;         ///< key path in the case file
  std::string symbol = {};  ///< as in the equations; empty without one
  std::string unit = {};    ///< "-" for pure numbers, empty for words
  ParameterType type = ParameterType::real;
  Scope scope = Scope::any;
  Presence presence = Presence::required;
  std::string fallback = {};  ///< preset: the default, as a user would write it; optional: what its absence means
  Range range = {};
  std::vector<std::string> choices = {};
  std::string implied = {};  ///< what the option means without a value; empty: it needs one
  std::string meaning = {};
  std::string former = {};  ///< the key of earlier releases, which is still read; empty where it is the same

  /// The part before the first dot: the section of the case file; empty for a key without section.
  std::string section() const;
  /// "-pinion_teeth" for "pinion.teeth".
  std::string option() const;
  /// The option of the former key; empty without one.
  std::string former_option() const;
  /// Whether yes and no are among the choices, which may also be written true and false.
  bool is_yes_or_no() const;
};

/// All parameters, grouped by section. A new parameter is one more record in src/input/parameter_table.cpp.
const std::vector<Parameter>& parameter_table();

/// The record of a key, also of a former one, or nullptr.
const Parameter* find_parameter(std::string_view name);

/// The record whose key is spelled most like name (edit distance; a forgotten section counts little).
const Parameter& nearest_parameter(std::string_view name);
/// The nearest parameter to an option such as "-grid_nz".
const Parameter& nearest_parameter_by_option(std::string_view option);

using ParameterValue = std::variant<int, double, std::string>;

/// Reads text as a value of the parameter. Throws InputError, beginning with origin (where the text stands:
/// "case.yaml:12" or "option -grid_nx"), when the type or the range is wrong.
ParameterValue parse_value(const Parameter& parameter, const std::string& text, const std::string& origin);

/// The shortest text that reads back as the same value.
std::string format_value(const ParameterValue& value);

/// What is allowed, in words: "a number > 0", "one of roelands, barus", "an odd whole number >= 17".
std::string describe_allowed(const Parameter& parameter);

/// The parameter part of the -help text.
std::string parameter_help();

/// The content of docs/parameters.md.
std::string parameter_markdown();

}  // namespace gearfilm

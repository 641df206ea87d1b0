#include "input/parameter.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "gearfilm/error.hpp"
#include "input/plain_text.hpp"

namespace gearfilm {
namespace {

std::string option_of(const std::string& name) {
  std::string option = "-" + name;
  std::ranges::replace(option, '.', '_');
  return option;
}

// Levenshtein distance: insertions, deletions and replacements that turn one word into the other.
int edit_distance(std::string_view from, std::string_view to) {
  std::vector<int> row(to.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    int diagonal = std::exchange(row[0], static_cast<int>(i) + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const int replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, diagonal + 1, replaced});
    }
  }
  return row.back();
}

// A key without its section, or in the wrong one ("nx", "contact.nx" for "grid.nx"), costs as much as three typing
// errors. Keys separate their section with a dot; options do not show theirs, so they are compared whole.
template <class Spelling>
const Parameter& nearest_by(std::string_view name, Spelling spelling) {
  constexpr int wrong_section = 3;
  const std::string_view name_in_section = name.substr(name.find('.') + 1);
  const auto distance = [&](const Parameter& parameter) {
    const std::string full = spelling(parameter);
    const std::size_t section = parameter.section().size();
    const std::string in_section = full.substr(section == 0 ? 0 : section + 1);
    return std::min(edit_distance(name, full), edit_distance(name_in_section, in_section) + wrong_section);
  };
  return *std::ranges::min_element(parameter_table(), {}, distance);
}

template <class Number>
std::optional<ParameterValue> read_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  // "inf" and "nan" are read as numbers, but no parameter can be either.
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(static_cast<double>(number)))
    return {};
  return number;
}

// Libraries that load and save YAML write "true" for "yes", in the spelling of their language.
std::string yes_or_no(const std::string& text) {
  std::string word = text;
  std::ranges::transform(word, word.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (word == "yes" || word == "true") return "yes";
  if (word == "no" || word == "false") return "no";
  return text;
}

std::optional<ParameterValue> read_value(const Parameter& parameter, const std::string& text) {
  if (parameter.type == ParameterType::integer) return read_number<int>(text);
  if (parameter.type == ParameterType::real) return read_number<double>(text);
  return parameter.is_yes_or_no() ? yes_or_no(text) : text;
}

bool is_allowed(const Parameter& parameter, const ParameterValue& value) {
  if (const int* number = std::get_if<int>(&value)) return parameter.range.contains(*number);
  if (const double* number = std::get_if<double>(&value)) return parameter.range.contains(*number);
  return parameter.type == ParameterType::text ||
         std::ranges::find(parameter.choices, std::get<std::string>(value)) != parameter.choices.end();
}

// Words become names of files, and strings in JSON and HDF5.
void require_readable(const std::string& text, const std::string& given) {
  if (first_unreadable(text) == std::string::npos) return;
  throw InputError(given + " is '" + text + "', with a control character or not UTF-8; give plain words in one line");
}

std::string describe_range(const Range& range) {
  const bool below = std::isfinite(range.upper);
  const bool above = std::isfinite(range.lower);
  const std::string upper = format_value(range.upper);
  const std::string lower = format_value(range.lower);
  if (above && below)
    return "in " + ((range.lower_open ? "(" : "[") + lower) + ", " + upper + (range.upper_open ? ")" : "]");
  if (above) return (range.lower_open ? "> " : ">= ") + lower;
  if (below) return (range.upper_open ? "< " : "<= ") + upper;
  return "";
}

std::string describe_type(const Parameter& parameter) {
  return parameter.type == ParameterType::integer ? "a whole number" : "a number";
}

bool has_unit(const Parameter& parameter) { return !parameter.unit.empty() && parameter.unit != "-"; }

std::string with_unit(const std::string& text, const Parameter& parameter) {
  return has_unit(parameter) ? text + " " + parameter.unit : text;
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = lower_open ? value > lower : value >= lower;
  const bool below = upper_open ? value < upper : value <= upper;
  return above && below && (!odd || std::fmod(value, 2.0) != 0.0);
}

std::string Parameter::section() const {
  const std::size_t dot = name.find('.');
  return dot == std::string::npos ? std::string() : name.substr(0, dot);
}

std::string Parameter::option() const { return option_of(name); }

std::string Parameter::former_option() const { return former.empty() ? former : option_of(former); }

bool Parameter::is_yes_or_no() const {
  return std::ranges::count(choices, "yes") == 1 && std::ranges::count(choices, "no") == 1;
}

const Parameter* find_parameter(std::string_view name) {
  const std::vector<Parameter>& table = parameter_table();
  const auto found = std::ranges::find_if(table, [&](const Parameter& parameter) {
    return parameter.name == name || (parameter.former == name && !name.empty());
  });
  return found == table.end() ? nullptr : &*found;
}

const Parameter& nearest_parameter(std::string_view name) {
  return nearest_by(name, [](const Parameter& parameter) { return parameter.name; });
}

const Parameter& nearest_parameter_by_option(std::string_view option) {
  while (option.starts_with('-')) option.remove_prefix(1);
  return nearest_by(option, [](const Parameter& parameter) { return parameter.option().substr(1); });
}

ParameterValue parse_value(const Parameter& parameter, const std::string& text, const std::string& origin) {
  const std::string given = origin + ": '" + parameter.name + "'";
  if (text.empty()) throw InputError(given + " has no value; give " + describe_allowed(parameter));
  require_readable(text, given);
  const std::string remedy = "; give " + describe_allowed(parameter) + " (" + parameter.meaning + ")";
  const std::optional<ParameterValue> value = read_value(parameter, text);
  if (!value) throw InputError(given + " is '" + text + "', not " + describe_type(parameter) + remedy);
  if (!is_allowed(parameter, *value))
    throw InputError(given + " is " + with_unit(text, parameter) + ", " +
                     (parameter.type == ParameterType::choice ? "not a choice" : "out of range") + remedy);
  return *value;
}

std::string format_value(const ParameterValue& value) {
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  if (const int* number = std::get_if<int>(&value)) return std::to_string(*number);
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, std::get<double>(value));
  // "1e-08" and "1e+13" are not yet the shortest: 1e-8, 1e13.
  std::string text(buffer, end);
  if (const std::size_t exponent = text.find('e'); exponent != std::string::npos) {
    const bool negative = text[exponent + 1] == '-';
    const std::size_t digits = text.find_first_not_of("+-0", exponent + 1);
    text = text.substr(0, exponent + 1) + (negative ? "-" : "") + text.substr(digits);
  }
  return text;
}

std::string describe_allowed(const Parameter& parameter) {
  if (parameter.type == ParameterType::text) return "a word";
  if (parameter.type == ParameterType::choice) {
    std::string list;
    for (const std::string& choice : parameter.choices) list += (list.empty() ? "" : ", ") + choice;
    return "one of " + list;
  }
  const std::string range = describe_range(parameter.range);
  const std::string kind = parameter.range.odd ? "an odd whole number" : describe_type(parameter);
  if (!range.empty()) return with_unit(kind + " " + range, parameter);
  return has_unit(parameter) ? kind + " in " + parameter.unit : kind;
}

}  // namespace gearfilm

#include "input/parameter_values.hpp"

#include <filesystem>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

std::string kind_name(Scope scope) {
  if (scope == Scope::gear_pair) return "gear_pair";
  if (scope == Scope::bare) return "contact or line";
  return scope == Scope::line ? "line" : "contact";
}

}  // namespace

void require_known_key(const std::string& name, const std::string& origin) {
  if (find_parameter(name)) return;
  throw InputError(origin + ": unknown key '" + name + "'; did you mean '" + nearest_parameter(name).name + "'?");
}

void ParameterValues::set(const std::string& name, const std::string& text, const std::string& origin) {
  require_known_key(name, origin);
  const Parameter& parameter = *find_parameter(name);
  entries_[parameter.name] = {parse_value(parameter, text, origin), origin};
}

void ParameterValues::complete() {
  if (!has("case.kind")) set("case.kind", find_parameter("case.kind")->fallback, by_default);
  check_scope();
  for (const Parameter& parameter : parameter_table()) {
    if (parameter.presence == Presence::preset && !has(parameter.name) && in_scope(parameter))
      set(parameter.name, parameter.fallback, by_default);
  }
  check_required();
  if (!has("case.name")) set("case.name", std::filesystem::path(file_).stem().string(), "name of the case file");
  if (!has("output.dir")) set("output.dir", "output/" + text("case.name"), by_default);
}

Scope ParameterValues::scope() const {
  if (text("case.kind") == "line") return Scope::line;
  return text("case.kind") == "contact" ? Scope::contact : Scope::gear_pair;
}

bool ParameterValues::in_scope(const Parameter& parameter) const {
  if (parameter.scope == Scope::bare) return scope() != Scope::gear_pair;
  return parameter.scope == Scope::any || parameter.scope == scope();
}

void ParameterValues::check_scope() const {
  for (const auto& [name, entry] : entries_) {
    const Parameter& parameter = *find_parameter(name);
    if (in_scope(parameter)) continue;
    throw InputError(entry.origin + ": '" + name + "' belongs to case.kind: " + kind_name(parameter.scope) +
                     ", but the case is a " + kind_name(scope()) + "; delete the key or set case.kind");
  }
}

void ParameterValues::check_required() const {
  std::string missing;
  for (const Parameter& parameter : parameter_table()) {
    if (!in_scope(parameter) || parameter.presence != Presence::required || has(parameter.name)) continue;
    missing += (missing.empty() ? "'" : ", '") + parameter.name + "' (" + parameter.meaning + ")";
  }
  if (missing.empty()) return;
  throw InputError(file_ + ": missing for a " + kind_name(scope()) + ": " + missing + "; add to the case file");
}

std::array<std::string, 2> ParameterValues::body_keys(const std::string& quantity) const {
  if (text("case.kind") != "gear_pair") return {"contact." + quantity + "_1", "contact." + quantity + "_2"};
  return {"pinion." + quantity, "wheel." + quantity};
}

void ParameterValues::refuse(const std::string& name, const std::string& what) const {
  throw InputError(origin(name) + ": '" + name + "' " + what);
}

void ParameterValues::require_both(const std::string& first, const std::string& second,
                                   const std::string& remedy) const {
  if (has(first) == has(second)) return;
  refuse(has(first) ? first : second, "is given without '" + (has(first) ? second : first) + "'; " + remedy);
}

void ParameterValues::require_not_both(const std::string& first, const std::string& second,
                                       const std::string& remedy) const {
  if (!has(first) || !has(second)) return;
  throw InputError(origin(first) + ": both '" + first + "' and '" + second + "' are given" + remedy);
}

std::vector<EchoedValue> ParameterValues::echo() const {
  std::vector<EchoedValue> echoed;
  for (const Parameter& parameter : parameter_table()) {
    const auto entry = entries_.find(parameter.name);
    if (entry != entries_.end()) echoed.push_back({parameter.name, format_value(entry->second.value), parameter.unit});
  }
  return echoed;
}

}  // namespace gearfilm

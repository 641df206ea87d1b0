#include "input/options.hpp"

#include <petscsys.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "gearfilm/error.hpp"
#include "input/case_file.hpp"
#include "numerics/tuned.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

// What PETSc and SLEPc read when the object concerned is created, after our check; and the same for this program's own
// solvers, by their prefixes.
constexpr auto object_prefixes = std::to_array<std::string_view>(
    {"ao_",         "bv_",         "da_",      "dm_",          "draw_",       "ds_",         "eps_",
     "fieldsplit_", "fn_",         "is_",      "ksp_",         "mat_",        "matmatmult_", "mfn_",
     "mg_",         "nep_",        "npc_",     "pc_",          "pep_",        "redundant_",  "rg_",
     "sf_",         "snes_",       "st_",      "sub_",         "svd_",        "tao_",        "ts_",
     "vec_",        "vecscatter_", "viewer_",  "steady_snes_", "steady_ksp_", "step_snes_",  "step_ksp_",
     "dry_ts_",     "dry_snes_",   "dry_ksp_", "modes_eps_",   "modes_ksp_",  "modes_st_",   "floquet_eps_"});
// Marches have their own time scheme, whose steps are theirs to choose.
constexpr auto chosen_by_program = std::to_array<std::string_view>({"step_ts_"});
// What PETSc reads at its start or when it ends, whatever the program does.
constexpr auto general_prefixes = std::to_array<std::string_view>(
    {"citations", "debug",  "error_output", "fp_trap",           "get_total_flops",   "help",      "info",
     "log_",      "malloc", "memory_",      "mpidump",           "objects_",          "on_error_", "options_",
     "petsc",     "saws",   "slepc",        "start_in_debugger", "stop_for_debugger", "use_gpu",   "version"});

// Option names do not depend on case, as in PETSc.
std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return lower;
}

template <class Prefixes>
bool begins_with_any(std::string_view option, const Prefixes& prefixes) {
  const std::string name = lower_case(option.substr(option.starts_with('-') ? 1 : 0));
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

// The parameter that an option is of, by its key or its former one, or nullptr.
const Parameter* parameter_of(std::string_view option) {
  const std::string name = lower_case(option);
  const auto found = std::ranges::find_if(parameter_table(), [&](const Parameter& parameter) {
    return lower_case(parameter.option()) == name ||
           (!parameter.former.empty() && lower_case(parameter.former_option()) == name);
  });
  return found == parameter_table().end() ? nullptr : &*found;
}

bool is_parameter_option(std::string_view option) { return parameter_of(option) != nullptr; }

struct Option {
  std::string name;  // with its dash
  std::string value;
};

// The options that nothing has read so far.
std::vector<Option> options_left() {
  PetscInt count = 0;
  char** names = nullptr;
  char** values = nullptr;
  petsc_check(PetscOptionsLeftGet(nullptr, &count, &names, &values));
  std::vector<Option> options;
  options.reserve(count);
  for (PetscInt n = 0; n < count; ++n) options.push_back({std::string("-") + names[n], values[n] ? values[n] : ""});
  petsc_check(PetscOptionsLeftRestore(nullptr, &count, &names, &values));
  return options;
}

std::string as_typed(const Option& option) {
  return option.value.empty() ? option.name : option.name + " " + option.value;
}

// What is unknown about an option, and what may be meant. PETSc takes "-grid_nx=65" as a whole for a name.
std::string unknown_option(const Option& option) {
  const std::string unknown = "unknown option '" + as_typed(option) + "'; did you mean '";
  const std::size_t equals = option.name.find('=');
  const std::string name = option.name.substr(0, equals);
  const bool known = is_petsc_option(name) || is_parameter_option(name);
  const std::string meant = known ? name : nearest_parameter_by_option(name).option();
  if (equals == std::string::npos) return unknown + meant + "'?";
  std::string value = option.name.substr(equals + 1);
  if (value.find(' ') != std::string::npos) value = '"' + value + '"';
  return unknown + meant + " " + value + "', with a blank in the place of '='?";
}

// The value in the database, empty if it was given without one; false where there is no such option.
bool find_option(const std::string& option, std::string& value) {
  const char* text = nullptr;
  PetscBool found = PETSC_FALSE;
  petsc_check(PetscOptionsFindPair(nullptr, nullptr, option.c_str(), &text, &found));
  value = text ? text : "";
  return found == PETSC_TRUE;
}

// The option of a parameter that is in the database, with its value; empty where there is none.
std::string find_option_of(const Parameter& parameter, std::string& value) {
  for (const std::string& option : {parameter.option(), parameter.former_option()}) {
    if (!option.empty() && find_option(option, value)) return option;
  }
  return {};
}

// Keeps options of a case file in the database for the time of a scope: a second case of the same process must not
// take them for the command line.
class FileOptions {
public:
  FileOptions() = default;
  ~FileOptions() {
    for (const std::string& option : options_) (void)PetscOptionsClearValue(nullptr, option.c_str());
  }
  FileOptions(const FileOptions&) = delete;
  FileOptions& operator=(const FileOptions&) = delete;

  void put(const std::string& option, const std::string& value) {
    petsc_check(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
    options_.push_back(option);
  }

private:
  std::vector<std::string> options_;
};

/// One of this program's tuned constants.
bool is_constant(std::string_view option) {
  const std::string name = lower_case(option.substr(option.starts_with('-') ? 1 : 0));
  for (const TunedConstant* constant = TunedConstant::first(); constant; constant = constant->next()) {
    if (constant->name() == name) return true;
  }
  return false;
}

}  // namespace

bool is_petsc_option(std::string_view option) {
  return is_constant(option) || begins_with_any(option, object_prefixes) || begins_with_any(option, general_prefixes);
}

void require_known_options(const std::vector<std::string>& arguments) {
  std::set<std::string> typed;
  for (const std::string& argument : arguments) typed.insert(lower_case(argument));
  for (const Option& option : options_left()) {
    const std::string name = lower_case(option.name);
    if (!typed.contains(name) && !typed.contains(std::string("-").append(name))) continue;
    if (begins_with_any(option.name, chosen_by_program)) {
      throw InputError("command line: '" + as_typed(option) +
                       "' cannot be given: marches use their own time scheme; "
                       "delete it (time.tolerance controls their steps)");
    }
    const bool with_equals = option.name.find('=') != std::string::npos;
    if (!with_equals && (is_petsc_option(option.name) || is_parameter_option(option.name))) continue;
    throw InputError("command line: " + unknown_option(option));
  }
}

void require_single_options(const std::vector<std::string>& arguments) {
  std::set<const Parameter*> given;
  for (const std::string& argument : arguments) {
    const Parameter* parameter = parameter_of(argument);
    if (!parameter || given.insert(parameter).second) continue;
    const std::string formerly = parameter->former.empty() ? "" : " (formerly '" + parameter->former_option() + "')";
    const std::string option = parameter->former.empty() ? argument : parameter->option();
    throw InputError("command line: option '" + option + "'" + formerly + " is given twice; delete one of the two");
  }
}

ParameterValues merge_with_options(const std::string& file, const std::vector<CaseFileEntry>& entries) {
  FileOptions file_options;
  std::map<std::string, std::string> origins;
  for (const CaseFileEntry& entry : entries) {
    const std::string origin = file + ":" + std::to_string(entry.line);
    const Parameter& parameter = *find_parameter(entry.name);
    parse_value(parameter, entry.value, origin);  // wrong even if the command line overrides it
    std::string overriding;
    if (!find_option_of(parameter, overriding).empty()) continue;
    file_options.put(parameter.option(), entry.value);
    origins[entry.name] = origin;
  }
  ParameterValues values(file);
  for (const Parameter& parameter : parameter_table()) {
    std::string value;
    const std::string option = find_option_of(parameter, value);
    if (option.empty()) continue;
    if (value.empty()) value = parameter.implied;
    const auto origin = origins.find(parameter.name);
    values.set(parameter.name, value, origin != origins.end() ? origin->second : "option " + option);
  }
  return values;
}

std::vector<std::string> unused_options() {
  std::vector<std::string> unused;
  for (const Option& option : options_left()) {
    if (!begins_with_any(option.name, general_prefixes)) unused.push_back(as_typed(option));
  }
  return unused;
}

}  // namespace gearfilm

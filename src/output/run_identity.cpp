#include "output/run_identity.hpp"

#include <algorithm>

#include "gearfilm/error.hpp"
#include "input/case_file.hpp"
#include "numerics/tuned.hpp"
#include "output/format_version.hpp"
#include "output/provenance.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {

namespace {

/// Calls each(name, value) for the tuned constants that have another value than by default.
template <class Each>
void for_each_changed_constant(Each each) {
  for (const TunedConstant* constant = TunedConstant::first(); constant; constant = constant->next()) {
    if (constant->value() != constant->by_default()) each(constant->name(), constant->value());
  }
}

}  // namespace

Summary identity_of(const CaseInput& problem, const std::string& command, const std::vector<std::string>& free) {
  Summary identity = {{"command", command}};
  for (const EchoedValue& echoed : problem.parameters.echo()) {
    const std::string section = find_parameter(echoed.name)->section();
    const bool may_differ =
        std::ranges::any_of(free, [&](const std::string& name) { return name == echoed.name || name == section; });
    if (!may_differ) identity[echoed.name] = echoed.value;
  }
  for_each_changed_constant([&](const std::string& name, double value) { identity[name] = format_value(value); });
  return identity;
}

void keep_identity(MPI_Comm comm, const std::filesystem::path& file, Summary identity) {
  identity["format"] = restart_format;
  write_json(comm, file, identity);
}

std::optional<Summary> read_identity(MPI_Comm comm, const std::filesystem::path& file) {
  int exists = 0;
  std::error_code ignored;
  if (rank_in(comm) == 0) exists = std::filesystem::exists(file, ignored);
  MPI_Bcast(&exists, 1, MPI_INT, 0, comm);
  if (!exists) return {};
  Summary identity = Summary::parse(read_text(comm, file.string(), "file"), nullptr, false);
  if (!identity.is_object()) {
    throw InputError("'" + file.string() + "' cannot be read; delete its folder, or choose another one");
  }
  require_restart_format(identity, file);
  identity.erase("format");
  return std::make_optional(std::move(identity));
}

void require_same_identity(const Summary& before, const Summary& now, const std::filesystem::path& file) {
  for (const Summary* side : {&before, &now}) {
    for (const auto& [name, value] : side->items()) {
      const std::string then = before.value(name, "absent"), today = now.value(name, "absent");
      if (then == today) continue;
      throw InputError("'" + file.parent_path().string() + "' holds another run, with " + name + " " + then +
                       " instead of " + today + "; choose another folder with -output_dir, or delete that one");
    }
  }
}

void write_identity(ResultsFile& file, const CaseInput& problem, const std::string& command) {
  file.attribute("/", "program", std::string("gearfilm"));
  file.attribute("/", "format_version", results_format);
  const Summary libraries = provenance(file.comm());
  for (const auto& [name, value] : libraries.items()) {
    file.attribute("/", name, value.is_string() ? value.get<std::string>() : value.dump());
  }
  file.attribute("/", "command", command);
  // Chosen bounds too, which the parameters do not show where they follow from M.
  file.attribute("/", "x_min", problem.numerics.domain.x_min);
  file.attribute("/", "x_max", problem.numerics.domain.x_max);
  file.attribute("/", "y_half", problem.numerics.domain.y_half);
  const Scales& scales = problem.scales;
  // Points of these have scales of their own.
  const bool of_one_pair = command != "sweep" && command != "continuation";
  for (const auto& [name, value] : {std::pair("length", scales.length),
                                    {"thickness", scales.thickness},
                                    {"pressure", scales.pressure},
                                    {"time", scales.time},
                                    {"force", scales.force(1.0)},
                                    {"velocity", scales.operation.entrainment_velocity}}) {
    if (of_one_pair) file.attribute("/scales", name, value);
  }
  for (const EchoedValue& echoed : problem.parameters.echo()) {
    const bool pure = echoed.unit.empty() || echoed.unit == "-";
    file.attribute("/parameters", echoed.name, pure ? echoed.value : echoed.value + " " + echoed.unit);
  }
  for_each_changed_constant([&](const std::string& name, double value) { file.attribute("/parameters", name, value); });
}

}  // namespace gearfilm

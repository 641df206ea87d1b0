#include "gearfilm/app/sweep_points.hpp"

#include <array>
#include <cstdio>
#include <fstream>

#include "gearfilm/error.hpp"
#include "gearfilm/io/case_file.hpp"

namespace gearfilm {
namespace {

// What may differ between a sweep and its continuation.
constexpr std::array<const char*, 2> free_parameters = {"output.dir", "sweep.groups"};

Summary parameters_of(const Case& problem) {
  Summary parameters;
  for (const EchoedValue& echoed : problem.parameters.echo()) {
    if (std::find(free_parameters.begin(), free_parameters.end(), echoed.name) != free_parameters.end()) continue;
    parameters[echoed.name] = echoed.value;
  }
  return parameters;
}

void require_same(const Summary& before, const Summary& now, const std::filesystem::path& folder) {
  for (const Summary* side : {&before, &now}) {
    for (const auto& [name, value] : side->items()) {
      const std::string then = before.value(name, "absent"), today = now.value(name, "absent");
      if (then == today) continue;
      throw InputError("'" + folder.string() + "' holds the points of another sweep, with " + name + " " + then +
                       " instead of " + today + "; choose another folder with -output_dir, or delete that one");
    }
  }
}

}  // namespace

SweepPoints::SweepPoints(MPI_Comm comm, const Case& problem) : folder_(problem.output_directory) {
  const std::filesystem::path identity = folder_ / "sweep.json";
  const Summary parameters = parameters_of(problem);
  int rank = 0, exists = 0;
  MPI_Comm_rank(comm, &rank);
  std::error_code ignored;
  if (rank == 0) exists = std::filesystem::exists(identity, ignored);
  MPI_Bcast(&exists, 1, MPI_INT, 0, comm);
  if (exists) {
    const Summary before = Summary::parse(read_text(comm, identity.string()), nullptr, false);
    if (!before.is_object()) {
      throw InputError("'" + identity.string() + "' cannot be read; delete the folder, or choose another one");
    }
    require_same(before, parameters, folder_);
  } else {
    write_summary(comm, identity, parameters);
  }
  if (rank == 0) std::filesystem::create_directories(folder_ / "points");
  MPI_Barrier(comm);
}

std::filesystem::path SweepPoints::file(const SweepPoint& point) const {
  char name[32];
  std::snprintf(name, sizeof name, "%s_%04zu.json", point.direction == SweepDirection::up ? "up" : "down", point.index);
  return folder_ / "points" / name;
}

std::optional<Summary> SweepPoints::read(const SweepPoint& point) const {
  std::ifstream stream(file(point));
  if (!stream) return {};
  Summary result = Summary::parse(stream, nullptr, false);
  // Anything else is not a point that was written whole.
  if (!result.is_object() || !(result.contains("error") || result.contains("monodromy"))) return {};
  return result;
}

void SweepPoints::write(MPI_Comm group, const SweepPoint& point, const Summary& result) const {
  write_summary(group, file(point), result);
}

}  // namespace gearfilm

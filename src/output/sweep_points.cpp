#include "output/sweep_points.hpp"

#include <cstdio>
#include <fstream>

#include "output/file_ownership.hpp"
#include "output/run_identity.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

// What may differ between a sweep and its continuation.
const std::vector<std::string> free_in_sweeps = {"output.dir", "sweep.groups",    "restart",
                                                 "time_limit", "keep_checkpoint", "solver.processes"};

std::string name_of(const SweepPoint& point) {
  char name[32];
  std::snprintf(name, sizeof name, "%s_%04zu", point.direction == SweepDirection::up ? "up" : "down", point.index);
  return name;
}

}  // namespace

SweepPoints::SweepPoints(MPI_Comm comm, const CaseInput& problem, const std::string& command)
    : folder_(problem.run.directory) {
  const std::filesystem::path file = folder_ / (command + ".json");
  const Summary identity = identity_of(problem, command, free_in_sweeps);
  require_replaceable(comm, {file});
  if (const std::optional<Summary> before = read_identity(comm, file)) {
    require_same_identity(*before, identity, file);
  } else {
    require_removable(comm, folder_ / "points");
    keep_identity(comm, file, identity);
  }
  write_together(comm, folder_, [&] {
    if (rank_in(comm) == 0) std::filesystem::create_directories(folder_ / "points");
  });
}

std::filesystem::path SweepPoints::file(const SweepPoint& point, const std::string& extension) const {
  return folder_ / "points" / (name_of(point) + extension);
}

std::optional<Summary> SweepPoints::read(MPI_Comm group, const SweepPoint& point) const {
  std::string text;
  if (rank_in(group) == 0) {
    std::ifstream stream(file(point));
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  broadcast(group, text);
  Summary result = Summary::parse(text, nullptr, false);
  // Anything else is not a point that was written whole.
  if (!result.is_object() || !(result.contains("error") || result.contains("monodromy") || result.contains("poincare")))
    return {};
  return result;
}

void SweepPoints::write(MPI_Comm group, const SweepPoint& point, const Summary& result) const {
  write_json(group, file(point), result);
}

void SweepPoints::complete(MPI_Comm comm) const {
  write_together(comm, folder_, [&] {
    if (rank_in(comm) != 0) return;
    std::vector<std::filesystem::path> superfluous;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "points")) {
      const std::filesystem::path extension = entry.path().extension();
      if (extension == ".checkpoint" || extension == ".films" || extension == ".part") {
        superfluous.push_back(entry.path());
      }
    }
    for (const std::filesystem::path& path : superfluous) {
      if (std::filesystem::is_directory(path)) {
        remove_all_written_here(path);
      } else {
        remove_if_written_here(path);
      }
    }
  });
}

}  // namespace gearfilm

#include "gearfilm/app/resumable_run.hpp"

#include <array>

#include "gearfilm/error.hpp"
#include "gearfilm/io/run_identity.hpp"

namespace gearfilm {
namespace {

// What may differ between a run and its continuation. A march can go on beyond its first end.
constexpr std::array<const char*, 7> free_parameters = {
    "output.dir", "restart", "time_limit", "keep_checkpoint", "mesh_periods", "output.spectrum_periods", "case.name"};

}  // namespace

ResumableRun::ResumableRun(const Case& problem, const Grid& grid, const std::string& command)
    : comm_(grid.comm()),
      keep_(problem.keep_checkpoint),
      directory_(comm_, problem.output_directory),
      folder_(directory_ / "checkpoint"),
      stop_(problem.time_limit) {
  const Summary identity = identity_of(problem, command, free_parameters);
  const std::filesystem::path file = folder_ / "run.json";
  if (problem.restart) {
    const std::optional<Summary> before = read_identity(comm_, file);
    if (!before) {
      throw InputError(
          "'" + problem.output_directory.string() +
          "' has nothing to go on from: no run was begun there, or it was completed; start without -restart");
    }
    require_same_identity(*before, identity, file);
    checkpoint_.emplace(grid, folder_, Checkpoint::Begin::where_it_stopped);
  } else {
    directory_.remove_earlier_results();
    checkpoint_.emplace(grid, folder_, Checkpoint::Begin::anew);
    write_summary(comm_, file, identity);
  }
}

void ResumableRun::complete() {
  if (!keep_) checkpoint_->remove();
}

}  // namespace gearfilm

#include "output/resumable_run.hpp"

#include "gearfilm/error.hpp"
#include "output/file_ownership.hpp"
#include "output/run_identity.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

// What says nothing of the results.
const std::vector<std::string> conduct = {"output.dir", "restart", "time_limit", "keep_checkpoint", "solver.processes"};

// What may differ between a run and its continuation. A march can go on beyond its first end.
const std::vector<std::string> free_parameters = {"output.dir",
                                                  "restart",
                                                  "time_limit",
                                                  "keep_checkpoint",
                                                  "solver.processes",
                                                  "mesh_periods",
                                                  "output.spectrum_periods",
                                                  "case.name"};

std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

}  // namespace

ResumableRun::ResumableRun(const CaseInput& problem, const Grid& grid, const std::string& command,
                           const std::vector<std::string>& free_sections)
    : comm_(grid.comm()),
      keep_(problem.run.keep_checkpoint),
      whole_identity_(identity_of(problem, command, conduct)),
      directory_(comm_, problem.run.directory),
      folder_(directory_ / "checkpoint"),
      stop_(problem.run.time_limit) {
  const Summary identity = identity_of(problem, command, joined(free_parameters, free_sections));
  const std::filesystem::path file = identity_file();
  if (problem.run.restart) {
    const std::optional<Summary> before = read_identity(comm_, file);
    if (!before) refuse_restart();
    require_same_identity(*before, identity, file);
    checkpoint_.emplace(grid, folder_, Checkpoint::Begin::where_it_stopped);
  } else {
    require_removable(comm_, folder_);
    directory_.remove_earlier_results();
    forget();
    checkpoint_.emplace(grid, folder_, Checkpoint::Begin::anew);
    keep_identity(comm_, file, identity);
  }
}

void ResumableRun::refuse_restart() const {
  std::string folder("'");
  folder.append(directory_.path().string()).append("'");
  const std::filesystem::path complete = directory_ / "run.json";
  if (const std::optional<Summary> before = read_identity(comm_, complete)) {
    require_same_identity(*before, whole_identity_, complete);
    throw NothingLeft(folder +
                      " holds this run, which is complete: nothing is left to do (without -restart it is "
                      "computed again)");
  }
  throw InputError(folder + " has nothing to go on from: no run was begun there; start without -restart");
}

// Goes before the rest of the folder: a program killed meanwhile leaves nothing that looks as if it could go on.
void ResumableRun::forget() const {
  if (rank_in(comm_) == 0) remove_if_written_here(identity_file());
}

void ResumableRun::complete() {
  keep_identity(comm_, directory_ / "run.json", whole_identity_);
  if (keep_) return;
  forget();
  checkpoint_->remove();
}

std::optional<std::string> parameter_of_kept_run(MPI_Comm comm, const std::filesystem::path& directory,
                                                 const std::string& name) {
  for (const std::filesystem::path& file : {directory / "checkpoint" / "run.json", directory / "run.json"}) {
    const std::optional<Summary> kept = read_identity(comm, file);
    if (kept && kept->contains(name)) return kept->at(name).get<std::string>();
  }
  return {};
}

}  // namespace gearfilm

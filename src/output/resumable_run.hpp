// What a command needs that can be stopped and continued: its folder, what it keeps there, and whether it is to
// stop.
//
//   DIR/checkpoint/run.json    the command and its parameters, while the run is not complete
//   DIR/checkpoint/...         checkpoint.hpp
//   DIR/run.json               of a complete run
#pragma once

#include "input/case.hpp"
#include "output/checkpoint.hpp"
#include "output/output_directory.hpp"
#include "output/stop_request.hpp"

namespace gearfilm {

class ResumableRun {
public:
  /// Begins again, without what an earlier run has left in the folder; or goes on (restart). Throws InputError where
  /// there is nothing to go on from, or another run, and NothingLeft where the same run is complete. free_sections:
  /// parameters that may differ from it.
  ResumableRun(const CaseInput& problem, const Grid& grid, const std::string& command,
               const std::vector<std::string>& free_sections = {});

  const OutputDirectory& directory() const { return directory_; }
  Checkpoint& checkpoint() { return *checkpoint_; }
  const StopRequest& stop() const { return stop_; }

  /// All results are written: the checkpoint goes, unless it is to be kept.
  void complete();

private:
  std::filesystem::path identity_file() const { return folder_ / "run.json"; }
  void forget() const;
  /// Why there is nothing to go on from.
  void refuse_restart() const;

  MPI_Comm comm_;
  bool keep_;
  Summary whole_identity_;  ///< with those parameters that may differ when an unfinished run goes on
  OutputDirectory directory_;
  std::filesystem::path folder_;
  StopRequest stop_;
  std::optional<Checkpoint> checkpoint_;
};

/// The value of a parameter, by its name, in the run whose results or checkpoint a folder holds; nothing where it holds
/// none. Throws InputError where a file of the folder cannot be read. Collective.
std::optional<std::string> parameter_of_kept_run(MPI_Comm comm, const std::filesystem::path& directory,
                                                 const std::string& name);

}  // namespace gearfilm

// Agreement between processes: some of them read and write files, but all must go on alike.
#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "parallel/petsc.hpp"

namespace gearfilm {

/// This process's number, and how many there are.
int rank_in(MPI_Comm comm);
int processes_in(MPI_Comm comm);

/// The first process's text, on all. Collective, as are the others.
void broadcast(MPI_Comm comm, std::string& text);

/// Waits a few seconds for a request that others may never answer, since an error has struck this process alone;
/// whether they did.
bool wait_briefly(MPI_Request& request);

/// Waits for a request asleep: others may be done minutes later.
void wait_asleep(MPI_Request& request);

/// A barrier at which early processes sleep.
void wait_asleep(MPI_Comm comm);

/// The text of the lowest process that has one; empty where none has. All processes are waited for: they must come here
/// whatever strikes one of them.
std::string first_of_all_reasons(MPI_Comm comm, const std::string& own);

/// The text of the lowest process that has one, where others may be stuck in what failed here: a process that has a text
/// waits for the others for a few seconds, and returns its own where they do not come. Only for what ends the run.
std::string first_reason(MPI_Comm comm, const std::string& own);

/// Throws OutputError on all processes where any of them has a reason: the path, what its file system says, the remedy.
void require_written(MPI_Comm comm, const std::filesystem::path& path, const std::string& own_reason);

/// What keeps this process from an action; empty where it is done.
template <class Action>
std::string reason_against(Action&& action) {
  try {
    action();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// An action that writes, and may fail on some of the processes only: OutputError on all.
template <class Action>
void write_together(MPI_Comm comm, const std::filesystem::path& path, Action&& action) {
  require_written(comm, path, reason_against(action));
}

}  // namespace gearfilm

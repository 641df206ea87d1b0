// gearfilm: lubricant films and vibration of spur-gear pairs.   gearfilm COMMAND CASE.yaml [-option value ...]
#include <petscsys.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>

#include "app/command_line.hpp"
#include "app/session.hpp"
#include "gearfilm/error.hpp"
#include "input/plain_text.hpp"
#include "parallel/agreement.hpp"

namespace {

using gearfilm::Ending;
using Session = std::optional<gearfilm::Session>;  // absent where PETSc did not start

int end(const Session& session, const char* kind, const std::exception& error, Ending ending) {
  const std::string line = std::string("gearfilm: ") + kind + ": " + gearfilm::one_line(error.what());
  if (session) {
    session->end_together(line, ending);
  } else {
    if (gearfilm::rank_in(MPI_COMM_WORLD) == 0) std::fprintf(stderr, "%s\n", line.c_str());
  }
  return exit_status(ending);
}

/// HDF5 can neither close nor give up a file that it could not write, and would crash in MPI_Finalize.
[[noreturn]] void leave_without_finalize() {
  std::fflush(stdout);
  std::_Exit(exit_status(Ending::not_written));
}

}  // namespace

int main(int argc, char** argv) {
  // MPI and PETSc would not start, and say something else.
  if (std::error_code gone; std::filesystem::current_path(gone).empty()) {
    std::fprintf(stderr, "gearfilm: wrong input: the working directory is gone; change to one that exists\n");
    return exit_status(Ending::wrong_input);
  }
  const gearfilm::CommandLine command_line(argc, argv);
  Session session;  // outlives the messages, which only one process gives
  try {
    session.emplace(command_line.petsc_arguments);
    gearfilm::run(PETSC_COMM_WORLD, command_line);
    // Those that had nothing to do hear here how the others ended.
    const Ending ending = session->wait_for_end();
    if (ending == Ending::not_written) leave_without_finalize();
    if (ending == Ending::done) gearfilm::require_standard_output(PETSC_COMM_WORLD);
    return exit_status(ending);
  } catch (const gearfilm::InputError& error) {
    return end(session, "wrong input", error, Ending::wrong_input);
  } catch (const gearfilm::SolveError& error) {
    return end(session, "not solved", error, Ending::not_solved);
  } catch (const gearfilm::OutputError& error) {
    end(session, "not written", error, Ending::not_written);
    leave_without_finalize();
  } catch (const gearfilm::Stopped& reason) {
    return end(session, "stopped", reason, Ending::stopped);
  } catch (const std::bad_alloc&) {
    const gearfilm::SolveError error(
        "there is no more memory for this process; lower grid.nx and grid.ny, raise its limit (ulimit -v, or that of "
        "the batch system), or use more processes");
    return end(session, "not solved", error, Ending::not_solved);
  } catch (const std::exception& error) {
    return end(session, "internal error", error, Ending::not_solved);
  }
}

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

enum ExitStatus { done = 0, wrong_input = 1, not_solved = 2, stopped = 3 };

using Session = std::optional<gearfilm::Session>;  // absent where PETSc did not start

ExitStatus end(const Session& session, const char* kind, const std::exception& error, ExitStatus status) {
  const std::string line = std::string("gearfilm: ") + kind + ": " + gearfilm::one_line(error.what());
  if (session) {
    session->end_together(line, status);
  } else {
    if (gearfilm::rank_in(MPI_COMM_WORLD) == 0) std::fprintf(stderr, "%s\n", line.c_str());
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  // MPI and PETSc would not start, and say something else.
  if (std::error_code gone; std::filesystem::current_path(gone).empty()) {
    std::fprintf(stderr, "gearfilm: wrong input: the working directory is gone; change to one that exists\n");
    return wrong_input;
  }
  const gearfilm::CommandLine command_line(argc, argv);
  Session session;  // outlives the messages, which only one process gives
  try {
    session.emplace(command_line.petsc_arguments);
    gearfilm::run(PETSC_COMM_WORLD, command_line);
    gearfilm::require_standard_output(PETSC_COMM_WORLD);
    return done;
  } catch (const gearfilm::NothingLeft& reason) {
    (void)PetscPrintf(PETSC_COMM_WORLD, "%s\n", reason.what());
    return done;
  } catch (const gearfilm::InputError& error) {
    return end(session, "wrong input", error, wrong_input);
  } catch (const gearfilm::SolveError& error) {
    return end(session, "not solved", error, not_solved);
  } catch (const gearfilm::OutputError& error) {
    end(session, "not written", error, not_solved);
    // HDF5 can neither close nor give up a file that it could not write, and would crash in MPI_Finalize.
    std::fflush(stdout);
    std::_Exit(not_solved);
  } catch (const gearfilm::Stopped& reason) {
    return end(session, "stopped", reason, stopped);
  } catch (const std::bad_alloc&) {
    const gearfilm::SolveError error(
        "there is no more memory for this process; lower grid.nx and grid.ny, raise its limit (ulimit -v, or that of "
        "the batch system), or use more processes");
    return end(session, "not solved", error, not_solved);
  } catch (const std::exception& error) {
    return end(session, "internal error", error, not_solved);
  }
}

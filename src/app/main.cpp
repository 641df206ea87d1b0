// gearfilm: lubricant films and vibration of spur-gear pairs.   gearfilm COMMAND CASE.yaml [-option value ...]
#include <petscsys.h>

#include <cstdio>
#include <exception>
#include <optional>

#include "gearfilm/app/command_line.hpp"
#include "gearfilm/app/session.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/io/plain_text.hpp"

namespace {

enum ExitStatus { done = 0, wrong_input = 1, not_solved = 2 };

int report(const char* kind, const std::exception& error, ExitStatus status) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::fprintf(stderr, "gearfilm: %s: %s\n", kind, gearfilm::one_line(error.what()).c_str());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  const gearfilm::CommandLine command_line(argc, argv);
  std::optional<gearfilm::Session> session;  // outlives the messages, which only one process gives
  try {
    session.emplace(command_line.petsc_arguments());
    gearfilm::run(PETSC_COMM_WORLD, command_line);
    return done;
  } catch (const gearfilm::InputError& error) {
    return report("wrong input", error, wrong_input);
  } catch (const gearfilm::SolveError& error) {
    return report("not solved", error, not_solved);
  } catch (const std::exception& error) {
    // A broken invariant need not have struck all processes: the others must not wait for this one.
    std::fprintf(stderr, "gearfilm: internal error: %s\n", error.what());
    MPI_Abort(PETSC_COMM_WORLD, not_solved);
  }
}

// The command line: gearfilm COMMAND CASE.yaml [-option value ...].
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace gearfilm {

struct CommandLine {
  CommandLine(int argc, char** argv);

  std::string command;    ///< empty where none is given
  std::string case_file;  ///< empty where none is given
  /// First word that is neither the command, the case, an option nor an option's value; empty where there is none.
  std::string surplus;
  std::string misplaced;  ///< an option that stands before the command; empty where there is none
  bool wants_help = false;
  bool wants_version = false;
  /// What PETSc's options database is to read: everything but requests for help and version.
  std::vector<std::string> petsc_arguments;
};

/// Runs the command. Throws InputError for an unknown command or a missing case.
void run(MPI_Comm comm, const CommandLine& command_line);

}  // namespace gearfilm

// The command line: gearfilm COMMAND CASE.yaml [-option value ...].
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace gearfilm {

class CommandLine {
public:
  CommandLine(int argc, char** argv);

  const std::string& command() const { return command_; }      ///< empty where none is given
  const std::string& case_file() const { return case_file_; }  ///< empty where none is given
  bool wants_help() const { return help_; }
  bool wants_version() const { return version_; }
  /// First word that is neither the command, the case, an option nor an option's value; empty where there is none.
  const std::string& surplus() const { return surplus_; }
  /// An option that stands before the command; empty where there is none.
  const std::string& misplaced() const { return misplaced_; }
  /// What PETSc's options database is to read: everything but requests for help and version.
  std::vector<std::string> petsc_arguments() const { return petsc_arguments_; }

private:
  std::string command_;
  std::string case_file_;
  std::string surplus_;
  std::string misplaced_;
  bool help_ = false;
  bool version_ = false;
  std::vector<std::string> petsc_arguments_;
};

/// Runs the command. Throws InputError for an unknown command or a missing case.
void run(MPI_Comm comm, const CommandLine& command_line);

}  // namespace gearfilm

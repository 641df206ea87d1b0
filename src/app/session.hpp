// The life of MPI, PETSc and SLEPc around one run.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace gearfilm {

class Session {
public:
  /// arguments: the program's name, and what PETSc's options database is to read. Throws InputError for options with
  /// which PETSc does not start.
  explicit Session(std::vector<std::string> arguments);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Prints the last line of a run that ends early, once. Where not all processes come here, since what went wrong has
  /// struck some of them alone, the others, who would wait for these for ever, are ended with that status.
  void end_together(const std::string& line, int status) const;

private:
  void start_petsc();

  std::vector<std::string> arguments_;  ///< PETSc keeps pointers to them
  std::vector<char*> pointers_;
  int count_ = 0;
  char** values_ = nullptr;
  MPI_Comm ending_ = MPI_COMM_NULL;  ///< of all processes, used by end_together() alone
};

/// Throws OutputError on all processes where what was printed did not reach standard output: a full disk behind it.
/// Collective.
void require_standard_output(MPI_Comm comm);

}  // namespace gearfilm

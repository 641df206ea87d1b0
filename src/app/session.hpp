// The life of MPI, PETSc and SLEPc around one run.
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

namespace gearfilm {

/// How a run ends, from good to bad.
enum class Ending { done, wrong_input, not_solved, stopped, not_written };

/// Exit status for the shell: 0 done, 1 wrong input, 2 not solved or not written, 3 stopped.
int exit_status(Ending ending);

class Session {
public:
  /// arguments: the program's name, and what PETSc's options database is to read. Throws InputError for options with
  /// which PETSc does not start.
  explicit Session(std::vector<std::string> arguments);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Prints the last line of a run that ends early, once. An error may strike some processes alone, and the others
  /// would wait for these for ever: processes that come neither here nor to wait_for_end() are ended with that status.
  void end_together(const std::string& line, Ending ending) const;

  /// Sleeps until all processes are done, here or in end_together(), and says how: done where none has failed. Signals
  /// are left to those at work.
  Ending wait_for_end() const;

private:
  /// How all end, and which process is the first that does so: begun by each, known when the request is done.
  struct CommonEnd {
    std::array<int, 2> values{};
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void start_petsc();
  /// Rank of this process counted backwards: the number of processes for rank 0, 1 for the last. The largest place
  /// among the processes that fail is that of the lowest rank.
  int place() const;
  void begin_to_end(Ending own, CommonEnd& common) const;

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

// A part of the processes, for work that is too small for all.
#pragma once

#include <mpi.h>

namespace gearfilm {

/// The first `count` processes of a communicator, with one of their own. Made by all processes together.
class FirstProcesses {
public:
  FirstProcesses(MPI_Comm all, int count);
  ~FirstProcesses();
  FirstProcesses(const FirstProcesses&) = delete;
  FirstProcesses& operator=(const FirstProcesses&) = delete;

  /// Whether this process is one of them.
  bool contain_this() const { return comm_ != MPI_COMM_NULL; }
  MPI_Comm comm() const { return comm_; }

private:
  MPI_Comm comm_ = MPI_COMM_NULL;
};

}  // namespace gearfilm

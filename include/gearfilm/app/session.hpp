// The life of MPI, PETSc and SLEPc around one run.
#pragma once

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

private:
  void start_petsc();

  std::vector<std::string> arguments_;  ///< PETSc keeps pointers to them
  std::vector<char*> pointers_;
  int count_ = 0;
  char** values_ = nullptr;
};

}  // namespace gearfilm

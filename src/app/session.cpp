#include "app/session.hpp"

#include <hdf5.h>
#include <slepcsys.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "gearfilm/error.hpp"
#include "gearfilm/parallel/mpi_settings.hpp"
#include "parallel/agreement.hpp"
#include "parallel/events.hpp"

namespace gearfilm {

Session::Session(std::vector<std::string> arguments) : arguments_(std::move(arguments)) {
  for (std::string& argument : arguments_) pointers_.push_back(argument.data());
  pointers_.push_back(nullptr);
  count_ = static_cast<int>(arguments_.size());
  values_ = pointers_.data();

  prefer_mpi_settings();
  start_petsc();
  // Errors become exceptions (petsc.hpp); PETSc need not print its own traceback.
  petsc_check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
  // Nor HDF5.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  // A file that reaches the limit of its size is an error of the write, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  // A closed pipe ends the program quietly, as it ends others.
  petsc_check(PetscPopSignalHandler());
  register_events();
  MPI_Comm_dup(PETSC_COMM_WORLD, &ending_);
}

// Before it has started PETSc takes no error handler; what keeps it from starting is an option.
void Session::start_petsc() {
  PetscErrorPrintf = PetscErrorPrintfNone;
  try {
    petsc_check(SlepcInitialize(&count_, &values_, nullptr, nullptr));
  } catch (const PetscFailure& failure) {
    throw InputError(std::string("PETSc does not start with these options: ") + failure.what() +
                     "; check -options_file, -prefix_push and the like");
  }
  PetscErrorPrintf = PetscErrorPrintfDefault;
}

namespace {

// PETSc 3.22 and later print on stdout which options nothing has read; command_line.cpp says that on stderr.
void leave_unused_options_to_us() {
  PetscBool chosen = PETSC_FALSE;
  (void)PetscOptionsHasName(nullptr, nullptr, "-options_left", &chosen);
  if (!chosen) (void)PetscOptionsSetValue(nullptr, "-options_left", "no");
}

}  // namespace

Session::~Session() {
  MPI_Comm_free(&ending_);
  (void)PetscPopErrorHandler();
  leave_unused_options_to_us();
  (void)SlepcFinalize();
}

void require_standard_output(MPI_Comm comm) {
  errno = 0;
  std::string reason;
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    reason = errno != 0 ? std::generic_category().message(errno) : "what was printed did not arrive";
  }
  reason = first_reason(comm, reason);
  if (!reason.empty()) throw OutputError("cannot write to standard output: " + reason + "; results in files are whole");
}

void Session::end_together(const std::string& line, int status) const {
  const int rank = rank_in(ending_);
  if (rank == 0) std::fprintf(stderr, "%s\n", line.c_str());
  MPI_Request all_here = MPI_REQUEST_NULL;
  MPI_Ibarrier(ending_, &all_here);
  if (wait_briefly(all_here)) return;
  if (rank != 0) std::fprintf(stderr, "%s\n", line.c_str());
  MPI_Abort(ending_, status);
}

}  // namespace gearfilm

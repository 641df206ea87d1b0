#include "app/session.hpp"

#include <hdf5.h>
#include <slepcsys.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "gearfilm/error.hpp"
#include "output/stop_request.hpp"
#include "parallel/agreement.hpp"
#include "parallel/events.hpp"
#include "parallel/mpi_settings.hpp"

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

int exit_status(Ending ending) {
  return ending == Ending::not_written ? exit_status(Ending::not_solved) : static_cast<int>(ending);
}

int Session::place() const { return processes_in(ending_) - rank_in(ending_); }

void Session::begin_to_end(Ending own, CommonEnd& common) const {
  common.values = {static_cast<int>(own), own == Ending::done ? 0 : place()};
  MPI_Iallreduce(MPI_IN_PLACE, common.values.data(), 2, MPI_INT, MPI_MAX, ending_, &common.request);
}

void Session::end_together(const std::string& line, Ending ending) const {
  CommonEnd common;
  begin_to_end(ending, common);
  const bool together = wait_briefly(common.request);
  if (!together || common.values[1] == place()) std::fprintf(stderr, "%s\n", line.c_str());
  if (!together) MPI_Abort(ending_, exit_status(ending));
}

Ending Session::wait_for_end() const {
  const StopRequest signals_are_for_others({});
  CommonEnd common;
  begin_to_end(Ending::done, common);
  wait_asleep(common.request);
  return static_cast<Ending>(common.values[0]);
}

}  // namespace gearfilm

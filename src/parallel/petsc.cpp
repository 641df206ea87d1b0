#include "parallel/petsc.hpp"

#include <sys/resource.h>

#include <new>
#include <string>

namespace gearfilm {
namespace {

// One process runs one PETSc call tree at a time, so one slot is enough.
std::exception_ptr& kept_exception() {
  static std::exception_ptr exception;
  return exception;
}

// What PETSc says of an error code, and of the last error. Its specific text is `const char*` since PETSc 3.25.
template <class Specific>
std::string text_of(PetscErrorCode (*message_of)(PetscErrorCode, const char*[], Specific*), PetscErrorCode code) {
  const char* text = nullptr;
  Specific specific = nullptr;
  message_of(code, &text, &specific);
  std::string message;
  if (text) message += std::string(": ") + text;
  if (specific && *specific) message += std::string(" (") + specific + ")";
  return message;
}

bool& memory_lacked() {
  static bool lacked = false;
  return lacked;
}

/// PETSc returns codes that it does not know itself where it cannot allocate (3.18): so, where a limit is set.
bool lacks_memory(PetscErrorCode code) {
  if (code == PETSC_ERR_MEM) return true;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  rlimit limit{};
  return !text && getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

bool has_lacked_memory() { return memory_lacked(); }

PetscErrorCode keep_callback_exception(std::exception_ptr exception) {
  kept_exception() = std::move(exception);
  return PETSC_ERR_USER;
}

void petsc_check(PetscErrorCode code) {
  if (code == PETSC_SUCCESS) return;
  if (std::exception_ptr exception = std::exchange(kept_exception(), nullptr)) std::rethrow_exception(exception);
  if (lacks_memory(code)) {
    memory_lacked() = true;
    throw std::bad_alloc();
  }
  throw PetscFailure("PETSc error " + std::to_string(static_cast<int>(code)) + text_of(PetscErrorMessage, code));
}

}  // namespace gearfilm

#include "gearfilm/ehl/petsc.hpp"

#include <string>

namespace gearfilm {
namespace {

// One process runs one PETSc call tree at a time, so one slot is enough.
std::exception_ptr& kept_exception() {
  static std::exception_ptr exception;
  return exception;
}

}  // namespace

PetscErrorCode keep_callback_exception(std::exception_ptr exception) {
  kept_exception() = std::move(exception);
  return PETSC_ERR_USER;
}

void petsc_check(PetscErrorCode code) {
  if (code == PETSC_SUCCESS) return;
  if (std::exception_ptr exception = std::exchange(kept_exception(), nullptr)) std::rethrow_exception(exception);
  const char* text = nullptr;
  char* specific = nullptr;
  PetscErrorMessage(code, &text, &specific);
  std::string message = "PETSc error " + std::to_string(static_cast<int>(code));
  if (text) message += std::string(": ") + text;
  if (specific && *specific) message += std::string(" (") + specific + ")";
  throw PetscFailure(message);
}

}  // namespace gearfilm

// Ownership and errors of PETSc objects: the only place where PETSc's C conventions meet C++.
//
// Outside a callback: petsc_check(VecNorm(...)) turns an error code into an exception. Inside a callback given to
// PETSc: `return petsc_callback([&] { ... });` turns an exception into an error code; it is thrown again, as it was,
// by the petsc_check around the PETSc call that ran the callback.
#pragma once

#include <petscdmda.h>
#include <petscsnes.h>

#include <exception>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

// PETSc's own name since 3.19.
#if PETSC_VERSION_LT(3, 19, 0)
#define PETSC_SUCCESS ((PetscErrorCode)0)
#endif
// Since 3.21.
#if PETSC_VERSION_LT(3, 21, 0)
#define SNESLineSearchShellSetApply SNESLineSearchShellSetUserFunc
#endif

#if defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "gearfilm needs a PETSc of real numbers in double precision"
#endif

namespace gearfilm {

/// A PETSc call failed: a broken invariant of this program, not of its input.
class PetscFailure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws PetscFailure, std::bad_alloc where memory is short, or the exception that a callback left behind, unless code
/// is PETSC_SUCCESS.
void petsc_check(PetscErrorCode code);

/// Whether PETSc has lacked memory. It may then have left objects half made, on which its own functions that destroy
/// them crash (3.18): they are left alone, since the program is about to end.
bool has_lacked_memory();

/// Keeps an exception until control is back on our side of PETSc.
PetscErrorCode keep_callback_exception(std::exception_ptr exception);

template <class Body>
PetscErrorCode petsc_callback(Body&& body) {
  try {
    std::forward<Body>(body)();
    return PETSC_SUCCESS;
  } catch (...) {
    return keep_callback_exception(std::current_exception());
  }
}

/// What PETSc calls with the context that it was given last: (context.*method)(arguments).
template <auto method>
struct Callback;
template <class Context, class... Arguments, void (Context::*method)(Arguments...)>
struct Callback<method> {
  static PetscErrorCode call(Arguments... arguments, void* context) {
    return petsc_callback([&] { (static_cast<Context*>(context)->*method)(arguments...); });
  }
};

/// Owner of one reference to a PETSc object.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class PetscHandle {
public:
  PetscHandle() = default;
  explicit PetscHandle(Object object) : object_(object) {}
  ~PetscHandle() { reset(); }
  PetscHandle(const PetscHandle&) = delete;
  PetscHandle& operator=(const PetscHandle&) = delete;
  PetscHandle(PetscHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  PetscHandle& operator=(PetscHandle&& other) noexcept {
    if (this != &other) {
      reset();
      object_ = std::exchange(other.object_, nullptr);
    }
    return *this;
  }

  operator Object() const { return object_; }
  /// For PETSc's creating functions: releases what is held and gives the address to fill.
  Object* put() {
    reset();
    return &object_;
  }
  void reset() {
    if (object_ && !has_lacked_memory()) destroy(&object_);
    object_ = nullptr;
  }

private:
  Object object_ = nullptr;
};

using OwnedVec = PetscHandle<Vec, VecDestroy>;
using OwnedMat = PetscHandle<Mat, MatDestroy>;
using OwnedKSP = PetscHandle<KSP, KSPDestroy>;
using OwnedPC = PetscHandle<PC, PCDestroy>;
using OwnedSNES = PetscHandle<SNES, SNESDestroy>;
using OwnedDM = PetscHandle<DM, DMDestroy>;

/// How many values of a vector are here.
inline std::size_t local_size(Vec vec) {
  PetscInt size = 0;
  petsc_check(VecGetLocalSize(vec, &size));
  return static_cast<std::size_t>(size);
}

/// The local part of a vector, for the time of a scope.
class VecReading {
public:
  explicit VecReading(Vec vec) : vec_(vec), size_(local_size(vec)) { petsc_check(VecGetArrayRead(vec_, &first_)); }
  ~VecReading() { (void)VecRestoreArrayRead(vec_, &first_); }
  VecReading(const VecReading&) = delete;
  VecReading& operator=(const VecReading&) = delete;
  std::span<const double> values() const { return {first_, size_}; }
  double operator[](std::size_t n) const { return first_[n]; }

private:
  Vec vec_;
  std::size_t size_;
  const double* first_ = nullptr;
};

class VecWriting {
public:
  explicit VecWriting(Vec vec) : vec_(vec), size_(local_size(vec)) { petsc_check(VecGetArray(vec_, &first_)); }
  ~VecWriting() { (void)VecRestoreArray(vec_, &first_); }
  VecWriting(const VecWriting&) = delete;
  VecWriting& operator=(const VecWriting&) = delete;
  std::span<double> values() const { return {first_, size_}; }
  double& operator[](std::size_t n) const { return first_[n]; }

private:
  Vec vec_;
  std::size_t size_;
  double* first_ = nullptr;
};

/// The context of a shell, a Mat or a PC.
template <class Context, class Shell>
Context& context_of(Shell shell) {
  Context* context = nullptr;
  if constexpr (std::is_same_v<Shell, Mat>) {
    petsc_check(MatShellGetContext(shell, &context));
  } else {
    petsc_check(PCShellGetContext(shell, &context));
  }
  return *context;
}

/// What PETSc calls of a shell: (context.*operation)(in, out).
template <auto operation, class Context, class Shell>
PetscErrorCode call_shell(Shell shell, Vec in, Vec out) {
  return petsc_callback([&] { (context_of<Context>(shell).*operation)(in, out); });
}

/// A matrix of so many local rows and columns whose product is (context.*multiply)(in, out). The context must outlive
/// it.
template <auto multiply, class Context>
OwnedMat shell_matrix(MPI_Comm comm, PetscInt rows, PetscInt columns, Context& context) {
  OwnedMat matrix;
  petsc_check(MatCreateShell(comm, rows, columns, PETSC_DETERMINE, PETSC_DETERMINE, &context, matrix.put()));
  PetscErrorCode (*product)(Mat, Vec, Vec) = call_shell<multiply, Context, Mat>;
  petsc_check(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(product)));
  return matrix;
}

/// A square shell matrix as above, cut among context.comm() as context.local_size() says.
template <auto multiply, class Context>
OwnedMat shell_matrix(Context& context) {
  const PetscInt size = context.local_size();
  return shell_matrix<multiply>(context.comm(), size, size, context);
}

/// Makes the preconditioner of a solver out = (context.*apply)(in). The context must outlive it.
template <auto apply, class Context>
PC use_shell_preconditioner(KSP ksp, const char* name, Context& context) {
  PC pc = nullptr;
  petsc_check(KSPGetPC(ksp, &pc));
  petsc_check(PCSetType(pc, PCSHELL));
  petsc_check(PCShellSetName(pc, name));
  petsc_check(PCShellSetContext(pc, &context));
  petsc_check(PCShellSetApply(pc, call_shell<apply, Context, PC>));
  return pc;
}

}  // namespace gearfilm

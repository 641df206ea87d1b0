// Linear solutions for natural modes: FGMRES with a system's own preconditioner, to the digits that eigenvalues need.
#pragma once

#include <string>

#include "gearfilm/error.hpp"
#include "numerics/newton.hpp"

namespace gearfilm {

class ModeSolver {
public:
  /// With a matrix of the system; both must outlive the solver. purpose: what the solutions are for, in messages.
  ModeSolver(LinearisedSystem& system, Mat matrix, double tolerance, int max_iterations, std::string purpose,
             Watcher watcher = {})
      : purpose_(std::move(purpose)), watcher_(std::move(watcher)) {
    petsc_check(KSPCreate(system.comm(), ksp_.put()));
    petsc_check(KSPSetOptionsPrefix(ksp_, "modes_"));
    petsc_check(KSPSetOperators(ksp_, matrix, matrix));
    configure_krylov(ksp_, system, tolerance, max_iterations);
    petsc_check(KSPSetErrorIfNotConverged(ksp_, PETSC_FALSE));
    petsc_check(KSPSetFromOptions(ksp_));
    if (watcher_) petsc_check(KSPMonitorSet(ksp_, Callback<&ModeSolver::watch>::call, this, nullptr));
  }
  ModeSolver(const ModeSolver&) = delete;
  ModeSolver& operator=(const ModeSolver&) = delete;

  /// Solves from what `change` holds, in the place of zero.
  void use_guesses() { petsc_check(KSPSetInitialGuessNonzero(ksp_, PETSC_TRUE)); }

  /// Returns its iterations. Throws SolveError where the solution does not converge. Collective.
  int apply(Vec rows, Vec change) {
    ++solutions_;
    petsc_check(KSPSolve(ksp_, rows, change));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    petsc_check(KSPGetConvergedReason(ksp_, &reason));
    if (reason < 0) {
      throw SolveError("a linear solution for " + purpose_ + " did not converge (" +
                       std::string(KSPConvergedReasons[reason]) + ")");
    }
    PetscInt iterations = 0;
    petsc_check(KSPGetIterationNumber(ksp_, &iterations));
    return static_cast<int>(iterations);
  }

private:
  void watch(KSP, PetscInt iteration, PetscReal) {
    watcher_(worded(purpose_, ": linear solution ", solutions_, ", Krylov iteration ", iteration));
  }

  OwnedKSP ksp_;
  std::string purpose_;
  Watcher watcher_;
  int solutions_ = 0;
};

}  // namespace gearfilm

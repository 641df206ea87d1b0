// Linear solutions for natural modes: FGMRES with a system's own preconditioner, to the digits that eigenvalues need.
#pragma once

#include <string>

#include "gearfilm/ehl/newton.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

class ModeSolver {
public:
  /// With a matrix of the system; both must outlive the solver. purpose: what the solutions are for, in messages.
  ModeSolver(LinearisedSystem& system, Mat matrix, double tolerance, int max_iterations, std::string purpose)
      : purpose_(std::move(purpose)) {
    petsc_check(KSPCreate(system.comm(), ksp_.put()));
    petsc_check(KSPSetOptionsPrefix(ksp_, "modes_"));
    petsc_check(KSPSetOperators(ksp_, matrix, matrix));
    configure_krylov(ksp_, system, tolerance, max_iterations);
    petsc_check(KSPSetErrorIfNotConverged(ksp_, PETSC_FALSE));
    petsc_check(KSPSetFromOptions(ksp_));
  }

  /// Throws SolveError where the solution does not converge. Collective.
  void apply(Vec rows, Vec change) {
    petsc_check(KSPSolve(ksp_, rows, change));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    petsc_check(KSPGetConvergedReason(ksp_, &reason));
    if (reason < 0) {
      throw SolveError("a linear solution for " + purpose_ + " did not converge (" +
                       std::string(KSPConvergedReasons[reason]) + ")");
    }
  }

private:
  OwnedKSP ksp_;
  std::string purpose_;
};

}  // namespace gearfilm

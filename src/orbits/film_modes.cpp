#include "orbits/film_modes.hpp"

#include <slepceps.h>

#include <cmath>

#include "gearfilm/error.hpp"
#include "orbits/mode_solver.hpp"

namespace gearfilm {
namespace {

/// Makes A^-1 the solver of SLEPc's shift-and-invert at shift zero.
void use_inverse(EPS eps, ModeSolver& inverse) {
  ST st = nullptr;
  KSP ksp = nullptr;
  petsc_check(EPSGetST(eps, &st));
  petsc_check(STSetType(st, STSINVERT));
  petsc_check(STSetMatMode(st, ST_MATMODE_SHELL));
  petsc_check(STGetKSP(st, &ksp));
  petsc_check(KSPSetType(ksp, KSPPREONLY));
  use_shell_preconditioner<&ModeSolver::apply>(ksp, "inverse of the films at rest", inverse);
}

}  // namespace

std::vector<FilmMode> film_modes(LubricatedPair& pair, Vec state, const FilmModeOptions& options) {
  FilmSystem& system = pair.system();
  pair.place(0.0);
  pair.linearise(state, {}, 0.0);
  const OwnedMat A = shell_jacobian(system), B = shell_matrix<&FilmSystem::multiply_transient>(system);
  ModeSolver inverse(system, A, options.krylov_tolerance, options.krylov_max_iterations,
                     "the natural modes of the films", options.watcher);
  PetscHandle<EPS, EPSDestroy> eps;
  petsc_check(EPSCreate(system.comm(), eps.put()));
  petsc_check(EPSSetOptionsPrefix(eps, "modes_"));
  petsc_check(EPSSetOperators(eps, A, B));
  petsc_check(EPSSetProblemType(eps, EPS_GNHEP));
  petsc_check(EPSSetTarget(eps, 0.0));
  petsc_check(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  petsc_check(EPSSetDimensions(eps, options.count, PETSC_DEFAULT, PETSC_DEFAULT));
  petsc_check(EPSSetTolerances(eps, options.tolerance, 100));
  use_inverse(eps, inverse);
  petsc_check(EPSSetFromOptions(eps));
  petsc_check(EPSSolve(eps));
  PetscInt found = 0;
  petsc_check(EPSGetConverged(eps, &found));
  if (found == 0) throw SolveError("the natural modes of the lubricated pair did not converge");
  std::vector<FilmMode> modes;
  // SLEPc may have found more than asked for; of a conjugate pair both are taken.
  const auto lacks_conjugate = [&] { return !modes.empty() && modes.back().eigenvalue.imag() > 0.0; };
  for (PetscInt n = 0; n < found && (n < options.count || lacks_conjugate()); ++n) {
    PetscScalar real = 0.0, imaginary = 0.0;
    PetscReal error = 0.0;
    petsc_check(EPSGetEigenvalue(eps, n, &real, &imaginary));
    petsc_check(EPSGetErrorEstimate(eps, n, &error));
    // SLEPc solves A y = mu B y: mu = -lambda, and of a pair the one with Im lambda > 0 comes first.
    modes.push_back({{-real, imaginary == 0.0 ? 0.0 : imaginary}, error});
  }
  return modes;
}

}  // namespace gearfilm

#include "numerics/newton.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numerics/compact_fgmres.hpp"
#include "numerics/solve_tolerance.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> free_below("newton_free_below", 0.03, "a pressure below this may vanish in one iteration");
const Tuned<double> patience("newton_patience", 10.0,
                             "growth of the merit that limited changes may bring in an iteration");
const Tuned<double> astray("newton_astray", 1000.0,
                           "growth of the norm over that of the first guess at which the iteration is given up");
const Tuned<int> relaxations("newton_relaxations", 8, "halvings of a full step that increases the merit");
const Tuned<double> growth_of_relaxed("newton_growth_of_relaxed", 3.0,
                                      "growth of the merit that a relaxed step may bring");
const Tuned<double> shortest_step("newton_shortest_step", 1e-3, "shortest part of a full step of Newton's method");
const Tuned<double> least_part("newton_least_part", 0.25,
                               "least part of a length that was too long that is tried next");

constexpr int restart = 20;

/// Limits each pressure's part of the change (the new state is state - change).
void limit_pressure_change(Vec state, Vec change, PetscInt pressures, const PressureLimits& limits) {
  const VecReading pressure(state);
  const VecWriting step(change);
  for (PetscInt n = 0; n < pressures; ++n) {
    if (pressure[n] > free_below) step[n] = std::min(step[n], limits.fall * pressure[n]);
    step[n] = std::max(step[n], -limits.rise);
  }
}

/// trial = state - length change, where no pressure becomes negative.
void step_to(Vec trial, Vec state, double length, Vec change, PetscInt pressures) {
  petsc_check(VecWAXPY(trial, -length, change, state));
  const VecWriting pressure(trial);
  for (PetscInt n = 0; n < pressures; ++n) pressure[n] = std::max(pressure[n], 0.0);
}

/// Whether a step of length 1 leads to another trial than the present one, on all processes together.
bool leads_elsewhere(Vec trial, Vec state, Vec change, PetscInt pressures) {
  const VecReading from(state), step(change), present(trial);
  const auto count = static_cast<PetscInt>(present.values().size());
  int moved = 0;
  for (PetscInt n = 0; n < count && moved == 0; ++n) {
    const double reached = from[n] - step[n];
    moved = (n < pressures ? std::max(reached, 0.0) : reached) != present[n];
  }
  MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_INT, MPI_LOR, PetscObjectComm(reinterpret_cast<PetscObject>(trial)));
  return moved != 0;
}

// Newton's direction would give d|F|^2/2 = -|F|^2 along it: no product with the Jacobian is needed to know the slope.
// The merit may come to this many times what it was.
void search(SNESLineSearch line_search, LinearisedSystem& system, double allowed) {
  const PetscInt pressures = system.pressure_count();
  SNES snes = nullptr;
  Vec state = nullptr, residual = nullptr, change = nullptr, trial = nullptr, trial_residual = nullptr;
  petsc_check(SNESLineSearchGetSNES(line_search, &snes));
  petsc_check(SNESLineSearchGetVecs(line_search, &state, &residual, &change, &trial, &trial_residual));
  PetscReal norm = 0.0, trial_norm = 0.0;
  PetscBool changed = PETSC_FALSE;
  petsc_check(SNESLineSearchPreCheck(line_search, state, change, &changed));
  norm = system.merit(residual);
  const auto take = [&](double length, Vec step) {
    step_to(trial, state, length, step, pressures);
    petsc_check(SNESComputeFunction(snes, trial, trial_residual));
    trial_norm = system.merit(trial_residual);
  };
  take(1.0, change);
  double part = 1.0;  // of Newton's step that `change` is
  if (const double excess = system.moved(); excess > 1.0) {
    part = 1.0 / excess;
    petsc_check(VecScale(change, part));
    take(1.0, change);
  }
  OwnedVec relaxed;
  double at_once = allowed;
  for (int n = 0; n < relaxations && trial_norm > norm; ++n) {
    if (!relaxed) {
      petsc_check(VecDuplicate(change, relaxed.put()));
      petsc_check(VecCopy(change, relaxed));
    }
    if (!system.relax_overshot_nodes(relaxed, change, residual, trial_residual)) break;
    at_once = std::max<double>(allowed, growth_of_relaxed);
    // A pressure that ended at zero may do so with the shorter change too.
    if (leads_elsewhere(trial, state, relaxed, pressures)) take(1.0, relaxed);
  }
  bool found = trial_norm < at_once * norm;
  for (double length = 1.0; !found; found = trial_norm < allowed * norm) {
    if (length < shortest_step || !std::isfinite(trial_norm)) {
      petsc_check(SNESLineSearchSetReason(line_search, SNES_LINESEARCH_FAILED_REDUCT));
      return;
    }
    const double fall = part * norm * norm;
    const double excess = 0.5 * (trial_norm * trial_norm - norm * norm) + fall * length;
    length = std::clamp(0.5 * fall * length * length / excess, least_part * length, 0.5 * length);
    take(length, change);
  }
  petsc_check(VecCopy(trial, state));
  system.copied(trial, state);
  petsc_check(VecCopy(trial_residual, residual));
  petsc_check(SNESLineSearchComputeNorms(line_search));
  petsc_check(SNESLineSearchSetReason(line_search, SNES_LINESEARCH_SUCCEEDED));
}

template <Growth growth>
PetscErrorCode line_search_within(SNESLineSearch own, void* context) {
  const double allowed = growth == Growth::tenfold ? double(patience) : 1.0;
  return petsc_callback([&] { search(own, *static_cast<LinearisedSystem*>(context), allowed); });
}

/// Chooses the tolerance of each linear solve once the iteration before it is done.
void choose_solve_tolerances(SNES snes, const SolveBounds& bounds) {
  petsc_check(SNESMonitorSet(
      snes,
      [](SNES own, PetscInt iteration, PetscReal norm, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          KSP ksp = nullptr;
          PetscReal relative = 0.0, absolute = 0.0, growth = 0.0, aim = 0.0, linear = 0.0;
          PetscInt iterations = 0;
          petsc_check(SNESGetKSP(own, &ksp));
          petsc_check(KSPGetTolerances(ksp, &relative, &absolute, &growth, &iterations));
          petsc_check(KSPGetResidualNorm(ksp, &linear));
          petsc_check(SNESGetTolerances(own, &aim, nullptr, nullptr, nullptr, nullptr));
          relative = static_cast<SolveTolerance*>(context)->next(static_cast<int>(iteration), norm, linear, aim);
          petsc_check(KSPSetTolerances(ksp, relative, absolute, growth, iterations));
        });
      },
      new SolveTolerance(bounds),
      [](void** context) -> PetscErrorCode {
        delete static_cast<SolveTolerance*>(*context);
        return PETSC_SUCCESS;
      }));
}

}  // namespace

double LinearisedSystem::merit(Vec rows) {
  PetscReal norm = 0.0;
  petsc_check(VecNorm(rows, NORM_2, &norm));
  return norm;
}

OwnedMat shell_jacobian(LinearisedSystem& system) { return shell_matrix<&LinearisedSystem::multiply>(system); }

void configure_krylov(KSP ksp, LinearisedSystem& system, double tolerance, int max_iterations) {
  petsc_check(KSPSetType(ksp, KSPFGMRES));
  petsc_check(KSPSetTolerances(ksp, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, max_iterations));
  petsc_check(KSPGMRESSetRestart(ksp, restart));
  use_shell_preconditioner<&LinearisedSystem::precondition>(ksp, "film multigrid", system);
}

void allow_growth(SNES snes, LinearisedSystem& system, Growth growth) {
  SNESLineSearch line_search = nullptr;
  petsc_check(SNESGetLineSearch(snes, &line_search));
  petsc_check(SNESLineSearchShellSetApply(
      line_search, growth == Growth::tenfold ? line_search_within<Growth::tenfold> : line_search_within<Growth::none>,
      &system));
}

void limit_changes(SNES snes, LinearisedSystem& system, Changes changes) {
  const bool limited = changes == Changes::limited;
  allow_growth(snes, system, limited ? Growth::tenfold : Growth::none);
  constexpr double usual = 1e4;  // PETSc's own
  petsc_check(SNESSetDivergenceTolerance(snes, limited ? double(astray) : usual));
  SNESLineSearch line_search = nullptr;
  petsc_check(SNESGetLineSearch(snes, &line_search));
  const auto limit = [](SNESLineSearch, Vec state, Vec change, PetscBool* changed, void* context) -> PetscErrorCode {
    return petsc_callback([&] {
      auto& limits = *static_cast<LinearisedSystem*>(context);
      limit_pressure_change(state, change, limits.pressure_count(), limits.pressure_limits());
      limits.project_change(state, change);
      *changed = PETSC_TRUE;
    });
  };
  // PETSc keeps the function that it has where it is given none.
  const auto leave = [](SNESLineSearch, Vec, Vec, PetscBool* changed, void*) -> PetscErrorCode {
    *changed = PETSC_FALSE;
    return PETSC_SUCCESS;
  };
  petsc_check(SNESLineSearchSetPreCheck(line_search, limited ? +limit : +leave, &system));
}

namespace {

/// Gives a configured SNES another norm of the residual at which to end, or number of iterations; what is empty stays.
void end_at(SNES snes, std::optional<double> norm, std::optional<int> most_iterations) {
  PetscReal aim = 0.0, relative = 0.0, step = 0.0;
  PetscInt iterations = 0, evaluations = 0;
  petsc_check(SNESGetTolerances(snes, &aim, &relative, &step, &iterations, &evaluations));
  petsc_check(SNESSetTolerances(snes, norm.value_or(aim), relative, step,
                                most_iterations.value_or(static_cast<int>(iterations)), evaluations));
}

}  // namespace

void aim_at(SNES snes, double norm) { end_at(snes, norm, {}); }

void allow_iterations(SNES snes, int most) { end_at(snes, {}, most); }

void configure_newton(SNES snes, LinearisedSystem& system, const NewtonOptions& options, double weight) {
  petsc_check(SNESSetType(snes, SNESNEWTONLS));
  petsc_check(SNESSetTolerances(snes, options.tolerance * weight, 1e-30, 1e-12, options.max_iterations,
                                100 * options.max_iterations));
  petsc_check(SNESSetMaxLinearSolveFailures(snes, options.unsolved));
  SNESLineSearch line_search = nullptr;
  petsc_check(SNESGetLineSearch(snes, &line_search));
  petsc_check(SNESLineSearchSetType(line_search, SNESLINESEARCHSHELL));
  limit_changes(snes, system, options.limit_changes ? Changes::limited : Changes::free);
  KSP ksp = nullptr;
  petsc_check(SNESGetKSP(snes, &ksp));
  configure_krylov(ksp, system, options.krylov_tolerance, options.krylov_max_iterations);
  use_compact_fgmres(ksp, restart, [&system] { return system.in_single_precision(); });
  choose_solve_tolerances(snes, {.loosest = options.krylov_tolerance,
                                 .tightest = std::min(options.krylov_tolerance, options.tightest_krylov_tolerance)});
}

}  // namespace gearfilm

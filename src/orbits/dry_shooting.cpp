#include "orbits/dry_shooting.hpp"

#include <petscsnes.h>

#include <algorithm>

#include "gearfilm/error.hpp"
#include "orbits/monodromy.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

constexpr double shooting_tolerance = 1e-9;  // a free oscillation in the period

/// The map at the state where SNES is: residual and Jacobian ask for the same.
class MapThere {
public:
  explicit MapThere(const DryMap& map) : map_(map) {}

  void defect(SNES, Vec in, Vec out) {
    const VecReading x(in);
    const VecWriting r(out);
    const Eigen::VectorXd end = to_vector(map_(motion_from(x.values())).states.back());
    for (Eigen::Index n = 0; n < end.size(); ++n) r[n] = end[n] - x[n];
  }

  void slope(SNES, Vec in, Mat, Mat out) {
    const VecReading x(in);
    const Monodromy& by_start = map_(motion_from(x.values())).by_start;
    const auto size = static_cast<PetscInt>(by_start.rows());
    for (PetscInt row = 0; row < size; ++row) {
      for (PetscInt column = 0; column < size; ++column) {
        const double unit = row == column ? 1.0 : 0.0;
        petsc_check(MatSetValue(out, row, column, by_start(row, column) - unit, INSERT_VALUES));
      }
    }
    petsc_check(MatAssemblyBegin(out, MAT_FINAL_ASSEMBLY));
    petsc_check(MatAssemblyEnd(out, MAT_FINAL_ASSEMBLY));
  }

private:
  const DryMap& map_;
};

/// A pair in free flight comes back from where it is pushed: no factors, which there are none of then. Krylov's method
/// loses too many digits of a drive train, of which some motions all but repeat: singular values, those that are zero
/// left out.
void set_linear_solver(SNES snes, bool train) {
  KSP ksp = nullptr;
  PC pc = nullptr;
  petsc_check(SNESGetKSP(snes, &ksp));
  petsc_check(KSPGetPC(ksp, &pc));
  if (train) {
    petsc_check(KSPSetType(ksp, KSPPREONLY));
    petsc_check(PCSetType(pc, PCSVD));
    return;
  }
  petsc_check(KSPSetType(ksp, KSPGMRES));
  petsc_check(KSPSetTolerances(ksp, 1e-12, 1e-30, PETSC_DEFAULT, 10));
  petsc_check(PCSetType(pc, PCNONE));
}

/// As shoot(), but throws SolveError where the map has no value.
std::optional<Motion> solve(const DryMap& map, const Motion& guess) {
  MapThere there(map);
  OwnedVec state, defect;
  OwnedMat jacobian;
  OwnedSNES snes;
  const Eigen::VectorXd first = to_vector(guess);
  const auto size = static_cast<PetscInt>(first.size());
  petsc_check(VecCreateSeq(PETSC_COMM_SELF, size, state.put()));
  petsc_check(VecDuplicate(state, defect.put()));
  petsc_check(MatCreateSeqDense(PETSC_COMM_SELF, size, size, nullptr, jacobian.put()));
  petsc_check(SNESCreate(PETSC_COMM_SELF, snes.put()));
  petsc_check(SNESSetOptionsPrefix(snes, "dry_"));
  petsc_check(SNESSetFunction(snes, defect, Callback<&MapThere::defect>::call, &there));
  petsc_check(SNESSetJacobian(snes, jacobian, jacobian, Callback<&MapThere::slope>::call, &there));
  const bool train = map.mesh().train != nullptr;
  set_linear_solver(snes, train);
  petsc_check(SNESSetTolerances(snes, shooting_tolerance * map.oscillations(), 1e-30, train ? 0.0 : 1e-14, 30, 1000));
  petsc_check(SNESSetFromOptions(snes));
  {
    const VecWriting x(state);
    std::ranges::copy(first, x.values().begin());
  }
  petsc_check(SNESSolve(snes, nullptr, state));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  petsc_check(SNESGetConvergedReason(snes, &reason));
  if (reason <= 0) return {};
  return motion_from(VecReading(state).values());
}

}  // namespace

double DryMap::oscillations() const { return std::max(1.0, mesh_.frequency() * mesh_.period()); }

const DryFlowEnd& DryMap::operator()(const Motion& start) const {
  if (last_ && to_vector(last_->first) == to_vector(start)) return last_->second;
  if (watch_) watch_(mesh_.periods());
  last_ = std::pair(start, DryFlow(mesh_, damping_ratio_)(start, mesh_.periods()));
  return last_->second;
}

std::optional<Motion> shoot(const DryMap& map, const Motion& guess) {
  try {
    return solve(map, map.mesh().in_train(guess));
  } catch (const SolveError&) {
    return {};
  }
}

}  // namespace gearfilm

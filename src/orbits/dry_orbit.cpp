#include "gearfilm/orbits/dry_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "gearfilm/dynamics/dry_flow.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr double shooting_tolerance = 1e-9;  // a free oscillation in the mesh period
constexpr double strong_damping = 0.3;
constexpr double weak_damping = 0.002;  // from here to none at once
constexpr double widest_ratio = 0.5;    // of one damping to the last
constexpr double narrowest_ratio = 0.97;
// Of H_0, off an orbit of first order: the way to where the pair settles may be a long one without order.
constexpr std::array pushes = {0.05, -0.05, 0.2, -0.2, 0.02, -0.02};

// What damping takes in one mesh period: free oscillations in it times the damping ratio. Above this the pair forgets
// its start within a few mesh periods.
constexpr double forgetful = 0.1;

/// The map of the motion over one of its periods.
class DryMap {
public:
  explicit DryMap(const MeshModel& mesh) : mesh_(mesh) {}

  const MeshModel& mesh() const { return mesh_; }
  void set_damping_ratio(double zeta) { damping_ratio_ = zeta; }
  /// Free oscillations in a period, but no less than one.
  double oscillations() const { return std::max(1.0, mesh_.frequency() * mesh_.period()); }

  DryFlowEnd operator()(const Motion& start) const {
    return DryFlow(mesh_, mesh_, 1.0, damping_ratio_)(start, mesh_.periods());
  }

private:
  const MeshModel& mesh_;
  double damping_ratio_ = 0.0;
};

/// Solves map(motion) = motion by SNES from a guess. False where it does not converge.
bool shoot(const DryMap& map, Motion& motion) {
  OwnedVec state, defect;
  OwnedMat jacobian;
  OwnedSNES snes;
  petsc_check(VecCreateSeq(PETSC_COMM_SELF, 2, state.put()));
  petsc_check(VecDuplicate(state, defect.put()));
  petsc_check(MatCreateSeqDense(PETSC_COMM_SELF, 2, 2, nullptr, jacobian.put()));
  petsc_check(SNESCreate(PETSC_COMM_SELF, snes.put()));
  petsc_check(SNESSetOptionsPrefix(snes, "dry_"));
  petsc_check(SNESSetFunction(
      snes, defect,
      [](SNES, Vec in, Vec out, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          const VecReading x(in);
          const VecWriting r(out);
          const Motion end = (*static_cast<const DryMap*>(context))({x[0], x[1]}).states.back();
          r[0] = end.H0 - x[0];
          r[1] = end.V0 - x[1];
        });
      },
      const_cast<DryMap*>(&map)));
  petsc_check(SNESSetJacobian(
      snes, jacobian, jacobian,
      [](SNES, Vec in, Mat, Mat out, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          const VecReading x(in);
          const Monodromy slope = (*static_cast<const DryMap*>(context))({x[0], x[1]}).by_start;
          for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 2; ++column) {
              petsc_check(MatSetValue(out, row, column, slope[row][column] - (row == column), INSERT_VALUES));
            }
          }
          petsc_check(MatAssemblyBegin(out, MAT_FINAL_ASSEMBLY));
          petsc_check(MatAssemblyEnd(out, MAT_FINAL_ASSEMBLY));
        });
      },
      const_cast<DryMap*>(&map)));
  // A pair in free flight comes back from where it is pushed: no factors, which there are none of then.
  KSP ksp = nullptr;
  PC pc = nullptr;
  petsc_check(SNESGetKSP(snes, &ksp));
  petsc_check(KSPSetType(ksp, KSPGMRES));
  petsc_check(KSPSetTolerances(ksp, 1e-12, 1e-30, PETSC_DEFAULT, 10));
  petsc_check(KSPGetPC(ksp, &pc));
  petsc_check(PCSetType(pc, PCNONE));
  petsc_check(SNESSetTolerances(snes, shooting_tolerance * map.oscillations(), 1e-30, 1e-14, 30, 1000));
  petsc_check(SNESSetFromOptions(snes));
  {
    const VecWriting x(state);
    x[0] = motion.H0;
    x[1] = motion.V0;
  }
  petsc_check(SNESSolve(snes, nullptr, state));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  petsc_check(SNESGetConvergedReason(snes, &reason));
  if (reason <= 0) return false;
  const VecReading x(state);
  motion = {x[0], x[1]};
  return true;
}

DryOrbit describe(const DryMap& map, const Motion& start) {
  const DryFlowEnd end = map(start);
  return {start, end.by_start, end.extremes.largest_force};
}

/// What the pair comes to from there, or from rest, when it is left to itself.
Motion settle(DryMap& map, double damping_ratio, const std::optional<Motion>& from) {
  map.set_damping_ratio(damping_ratio);
  const double periods = std::ceil(10.0 + 2.0 / (damping_ratio * map.oscillations()));
  const MeshModel& mesh = map.mesh();
  Motion end = from ? *from : DryMarch::balance(mesh, DryForce(mesh), 0.0);
  DryFlow::march(mesh, damping_ratio, end, static_cast<int>(periods) * mesh.periods(),
                 [&](const DryPeriod& period) { end = period.motion; });
  return end;
}

/// The orbit of a strongly damped pair, followed to less damping. Returns the damping reached.
double follow_from_strong_damping(DryMap& map, double damping_ratio, Motion& start) {
  double damping = std::max(strong_damping, damping_ratio), ratio = widest_ratio;
  start = settle(map, damping, {});
  if (!shoot(map, start)) return HUGE_VAL;
  while (damping > damping_ratio) {
    const double next = ratio * damping < std::max(weak_damping, damping_ratio) ? damping_ratio : ratio * damping;
    Motion trial = start;
    map.set_damping_ratio(next);
    if (shoot(map, trial)) {
      start = trial;
      damping = next;
      ratio = std::max(widest_ratio, ratio * ratio);
      continue;
    }
    ratio = std::sqrt(ratio);
    if (ratio <= narrowest_ratio) continue;
    // The branch ends: what the pair settles on with less damping is another one.
    const double less = std::max(widest_ratio * damping, std::max(weak_damping, damping_ratio));
    if (less >= damping) return damping;
    start = settle(map, less, start);
    if (!shoot(map, start)) return damping;
    damping = less;
    ratio = widest_ratio;
  }
  return damping;
}

/// What the pair settles on when it is pushed off the orbit of first order: that one itself, where it is stable.
DryOrbit find_beside_first_order(DryMap& map, double damping_ratio) {
  MeshModel simple = map.mesh();
  simple.order = 1;
  const Motion first_order = find_dry_orbit(simple, damping_ratio).start;
  for (const double push : pushes) {
    Motion start = settle(map, std::max(damping_ratio, weak_damping), Motion{first_order.H0 + push, first_order.V0});
    map.set_damping_ratio(damping_ratio);
    if (shoot(map, start)) return describe(map, start);
  }
  throw SolveError("no periodic orbit of the dry pair found that repeats after " +
                   std::to_string(map.mesh().periods()) + " mesh periods");
}

}  // namespace

DryOrbit find_dry_orbit(const MeshModel& mesh, double damping_ratio) {
  DryMap map(mesh);
  if (mesh.order > 1) return find_beside_first_order(map, damping_ratio);
  Motion start;
  if (damping_ratio * map.oscillations() > forgetful) {
    start = settle(map, damping_ratio, {});
    if (shoot(map, start)) return describe(map, start);
    throw SolveError("the dry pair does not settle on a periodic orbit at damping ratio " +
                     std::to_string(damping_ratio));
  }
  const double reached = follow_from_strong_damping(map, damping_ratio, start);
  if (reached > damping_ratio) {
    throw SolveError("no periodic orbit of the dry pair found at damping ratio " + std::to_string(damping_ratio) +
                     ": continued from higher damping down to " + std::to_string(reached));
  }
  return describe(map, start);
}

DryOrbit dry_start(const MeshModel& mesh) {
  DryMap map(mesh);
  // A slow pair swings often in a mesh period, on thin films that damp it more.
  const bool slow = typical_film_damping * map.oscillations() > forgetful;
  const double damping = slow ? slow_film_damping : typical_film_damping;
  try {
    return find_dry_orbit(mesh, damping);
  } catch (const SolveError&) {
    return {.start = settle(map, damping, {})};
  }
}

DryOrbit dry_orbit_from(const MeshModel& mesh, double damping_ratio, const Motion& near) {
  if (auto orbit = follow_dry_orbit(mesh, damping_ratio, near)) return *orbit;
  DryMap map(mesh);
  Motion start = settle(map, std::max(damping_ratio, weak_damping), near);
  map.set_damping_ratio(damping_ratio);
  if (shoot(map, start)) return describe(map, start);
  std::ostringstream message;
  message << "no periodic orbit of the dry pair found from H0 = " << near.H0 << ", V0 = " << near.V0
          << " (start.H0, start.V0): at damping ratio " << damping_ratio << " it comes to (" << start.H0 << ", "
          << start.V0 << "), which does not repeat after " << mesh.periods()
          << " mesh period(s); try another periodic.order, or begin at another place";
  throw SolveError(message.str());
}

std::optional<DryOrbit> follow_dry_orbit(const MeshModel& mesh, double damping_ratio, const Motion& near) {
  DryMap map(mesh);
  map.set_damping_ratio(damping_ratio);
  Motion start = near;
  if (!shoot(map, start)) return {};
  return describe(map, start);
}

}  // namespace gearfilm

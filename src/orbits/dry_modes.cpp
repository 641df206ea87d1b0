#include "gearfilm/orbits/dry_modes.hpp"

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"
#include "gearfilm/parallel/petsc.hpp"

namespace gearfilm {
namespace {

OwnedMat dense(const std::array<std::array<double, 2>, 2>& entries) {
  OwnedMat matrix;
  petsc_check(MatCreateSeqDense(PETSC_COMM_SELF, 2, 2, nullptr, matrix.put()));
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      petsc_check(MatSetValue(matrix, row, column, entries[row][column], INSERT_VALUES));
    }
  }
  petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  return matrix;
}

}  // namespace

std::array<RotationalMode, 2> dry_modes(double stiffness, const std::array<double, 2>& base_radii,
                                        const GearInertias& inertias) {
  // Both matrices divided by their largest entries.
  const auto [r1, r2] = base_radii;
  const double mass_scale = std::max(inertias.pinion, inertias.wheel);
  const double stiffness_scale = stiffness * std::max(r1 * r1, r2 * r2);
  const double k = stiffness / stiffness_scale;
  const OwnedMat K = dense({{{k * r1 * r1, -k * r1 * r2}, {-k * r1 * r2, k * r2 * r2}}});
  const OwnedMat M = dense({{{inertias.pinion / mass_scale, 0.0}, {0.0, inertias.wheel / mass_scale}}});
  PetscHandle<EPS, EPSDestroy> eps;
  petsc_check(EPSCreate(PETSC_COMM_SELF, eps.put()));
  petsc_check(EPSSetOptionsPrefix(eps, "dry_"));
  petsc_check(EPSSetOperators(eps, K, M));
  petsc_check(EPSSetProblemType(eps, EPS_GHEP));
  petsc_check(EPSSetType(eps, EPSLAPACK));
  petsc_check(EPSSetWhichEigenpairs(eps, EPS_SMALLEST_REAL));
  petsc_check(EPSSetDimensions(eps, 2, PETSC_DEFAULT, PETSC_DEFAULT));
  petsc_check(EPSSetFromOptions(eps));
  petsc_check(EPSSolve(eps));
  PetscInt found = 0;
  petsc_check(EPSGetConverged(eps, &found));
  if (found < 2) throw SolveError("the eigenvalue problem of the dry gear pair did not converge");
  OwnedVec vector;
  petsc_check(MatCreateVecs(K, vector.put(), nullptr));
  std::array<RotationalMode, 2> modes;
  for (int n = 0; n < 2; ++n) {
    PetscScalar value = 0.0;
    petsc_check(EPSGetEigenpair(eps, n, &value, nullptr, vector, nullptr));
    const VecReading shape(vector);
    const double largest = std::abs(shape[0]) > std::abs(shape[1]) ? shape[0] : shape[1];
    // The rigid mode's eigenvalue is zero but for round-off, of either sign.
    modes[n] = {std::sqrt(std::max(0.0, value * stiffness_scale / mass_scale)) / (2.0 * std::numbers::pi),
                {shape[0] / largest, shape[1] / largest}};
  }
  return modes;
}

GearInertias disc_inertias(const std::array<double, 2>& base_radii, double mass) {
  const auto [r1, r2] = base_radii;
  const double factor = mass * (1.0 / (r1 * r1) + 1.0 / (r2 * r2));
  return {factor * std::pow(r1, 4), factor * std::pow(r2, 4)};
}

}  // namespace gearfilm

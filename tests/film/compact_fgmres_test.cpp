// A basis in single precision: the same solutions, to any number of digits.
#include "numerics/compact_fgmres.hpp"

#include <cmath>

#include "film_case.hpp"
#include "numerics/newton.hpp"

namespace gearfilm {
namespace {

/// A convection-diffusion matrix with entries of very different sizes, and its diagonal.
class Stretched final : public LinearisedSystem {
public:
  MPI_Comm comm() const override { return PETSC_COMM_SELF; }
  PetscInt local_size() const override { return 400; }
  PetscInt pressure_count() const override { return 0; }
  void multiply(Vec change, Vec rows) override {
    const VecReading in(change);
    const VecWriting out(rows);
    const PetscInt last = local_size() - 1;
    for (PetscInt n = 0; n <= last; ++n) {
      out[n] = scale(n) * ((2.0 + 0.3 * std::sin(n)) * in[n] - (n > 0 ? 1.2 * in[n - 1] : 0.0) -
                           (n < last ? 0.7 * in[n + 1] : 0.0));
    }
  }
  void precondition(Vec rows, Vec change) override {
    const VecReading in(rows);
    const VecWriting out(change);
    for (PetscInt n = 0; n < local_size(); ++n) out[n] = in[n] / (2.0 * scale(n));
  }

private:
  static double scale(PetscInt n) { return std::pow(10.0, 0.01 * static_cast<double>(n)); }
};

TEST(CompactFgmres, reaches_any_tolerance_in_hardly_more_iterations_than_in_double_precision) {
  Stretched system;
  const OwnedMat matrix = shell_jacobian(system);
  petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  OwnedVec rows, change, left;
  for (OwnedVec* vec : {&rows, &change, &left})
    petsc_check(VecCreateMPI(system.comm(), system.local_size(), PETSC_DETERMINE, vec->put()));
  {
    const VecWriting values(rows);
    for (PetscInt n = 0; n < system.local_size(); ++n) values[n] = std::cos(0.1 * static_cast<double>(n));
  }
  PetscReal all = 0.0;
  petsc_check(VecNorm(rows, NORM_2, &all));
  for (const double tolerance : {1e-2, 1e-4, 1e-12}) {
    std::vector<PetscInt> iterations;
    for (const char* kind : {"PETSc's", "double", "single"}) {
      OwnedKSP ksp;
      petsc_check(KSPCreate(system.comm(), ksp.put()));
      petsc_check(KSPSetOperators(ksp, matrix, matrix));
      configure_krylov(ksp, system, tolerance, 4000);
      constexpr int restart = 15;
      petsc_check(KSPGMRESSetRestart(ksp, restart));
      if (kind[0] != 'P') use_compact_fgmres(ksp, restart, [&] { return kind[0] == 's'; });
      petsc_check(KSPSolve(ksp, rows, change));
      KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
      petsc_check(KSPGetConvergedReason(ksp, &reason));
      petsc_check(KSPGetIterationNumber(ksp, &iterations.emplace_back()));
      EXPECT_EQ(reason, KSP_CONVERGED_RTOL) << kind;
      system.multiply(change, left);
      petsc_check(VecAYPX(left, -1.0, rows));
      PetscReal rest = 0.0;
      petsc_check(VecNorm(left, NORM_2, &rest));
      // The norm that the iteration reports is that of its rounded basis.
      EXPECT_LT(rest, 1.01 * tolerance * all) << kind;
    }
    report("%.0e: %d iterations of PETSc's, %d and %d in double and single precision", tolerance,
           static_cast<int>(iterations[0]), static_cast<int>(iterations[1]), static_cast<int>(iterations[2]));
    EXPECT_EQ(iterations[1], iterations[0]);
    EXPECT_LT(static_cast<double>(iterations[2]), 1.1 * static_cast<double>(iterations[0]));
  }
}

}  // namespace
}  // namespace gearfilm

// Newton's method on a system of two numbers.
#include "numerics/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearfilm {
namespace {

/// x = 1 and weight (y - x^2) = 0, without pressures: the whole first step from zero fulfils the first row and leaves
/// `weight` in the second, which counts in the norm of the rows but little in their merit. Every process has a copy.
class Bend : public LinearisedSystem {
public:
  explicit Bend(double weight) : weight_(weight) {}

  MPI_Comm comm() const override { return PETSC_COMM_SELF; }
  PetscInt local_size() const override { return 2; }
  PetscInt pressure_count() const override { return 0; }

  void residual(Vec state, Vec rows) const {
    const VecReading at(state);
    const VecWriting out(rows);
    out[0] = at[0] - 1.0;
    out[1] = weight_ * (at[1] - at[0] * at[0]);
  }
  void linearise(Vec state) { x_ = VecReading(state)[0]; }
  double merit(Vec rows) override {
    const VecReading own(rows);
    return std::hypot(own[0], own[1] / weight_);
  }
  void multiply(Vec change, Vec rows) override {
    const VecReading in(change);
    const VecWriting out(rows);
    out[0] = in[0];
    out[1] = weight_ * (in[1] - 2.0 * x_ * in[0]);
  }
  void precondition(Vec rows, Vec change) override {
    const VecReading in(rows);
    const VecWriting out(change);
    out[0] = in[0];
    out[1] = in[1] / weight_ + 2.0 * x_ * in[0];
  }

private:
  double weight_;
  double x_ = 0.0;
};

SNESConvergedReason solve(Bend& system) {
  OwnedVec state, rows;
  petsc_check(VecCreateSeq(PETSC_COMM_SELF, system.local_size(), state.put()));
  petsc_check(VecDuplicate(state, rows.put()));
  const OwnedMat jacobian = shell_jacobian(system);
  OwnedSNES snes;
  petsc_check(SNESCreate(system.comm(), snes.put()));
  petsc_check(SNESSetFunction(
      snes, rows,
      [](SNES, Vec at, Vec out, void* context) -> PetscErrorCode {
        return petsc_callback([&] { static_cast<Bend*>(context)->residual(at, out); });
      },
      &system));
  petsc_check(SNESSetJacobian(
      snes, jacobian, jacobian,
      [](SNES, Vec at, Mat, Mat, void* context) -> PetscErrorCode {
        return petsc_callback([&] { static_cast<Bend*>(context)->linearise(at); });
      },
      &system));
  configure_newton(snes, system, {.limit_changes = true}, 1.0);
  petsc_check(SNESSolve(snes, nullptr, state));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  petsc_check(SNESGetConvergedReason(snes, &reason));
  return reason;
}

// Behind a time step's good first guess, of a small norm, a tenfold growth is nothing to stop at.
TEST(Newton, goes_on_where_the_norm_grows_and_the_merit_does_not) {
  Bend steep(100.0);
  EXPECT_GT(solve(steep), 0);
}

TEST(Newton, gives_up_where_the_norm_has_grown_beyond_all_measure) {
  Bend far(1e5);
  EXPECT_EQ(solve(far), SNES_DIVERGED_DTOL);
}

}  // namespace
}  // namespace gearfilm

#include "gearfilm/ehl/stationary_newton.hpp"

#include <cmath>

namespace gearfilm {

// State and residual: the own nodes, and on the first process one more entry for H_0 and the load.
// The load row is weighted by sqrt(nodes), so that norm/sqrt(nodes) is a root mean square over the film plus the
// relative error of the load.
StationaryNewton::StationaryNewton(ContactFilm& film, const NewtonOptions& options)
    : film_(film),
      grid_(film.grid()),
      size_(grid_.local_size()),
      has_scalar_(grid_.rank() == 0),
      load_weight_(std::sqrt(static_cast<double>(grid_.nx()) * grid_.rows())),
      storage_rate_(size_),
      column_solution_(size_),
      jacobian_(shell_jacobian(*this)) {
  petsc_check(VecCreateMPI(grid_.comm(), local_size(), PETSC_DETERMINE, state_.put()));
  petsc_check(VecDuplicate(state_, residual_.put()));
  petsc_check(SNESCreate(grid_.comm(), snes_.put()));
  petsc_check(SNESSetOptionsPrefix(snes_, "steady_"));
  petsc_check(SNESSetFunction(
      snes_, residual_,
      [](SNES, Vec state, Vec residual, void* context) -> PetscErrorCode {
        return petsc_callback([&] { static_cast<StationaryNewton*>(context)->evaluate(state, residual); });
      },
      this));
  petsc_check(SNESSetJacobian(
      snes_, jacobian_, jacobian_,
      [](SNES, Vec, Mat matrix, Mat, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          static_cast<StationaryNewton*>(context)->update_jacobian();
          petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
          petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
        });
      },
      this));
  configure_newton(snes_, *this, options, load_weight_);
  petsc_check(SNESSetFromOptions(snes_));
}

double StationaryNewton::broadcast(double value) const {
  if (grid_.processes() > 1) MPI_Bcast(&value, 1, MPI_DOUBLE, 0, grid_.comm());
  return value;
}

void StationaryNewton::evaluate(Vec state, Vec residual) {
  const VecReading in(state);
  const VecWriting out(residual);
  const double H0 = broadcast(has_scalar_ ? in[size_] : 0.0);
  const double* rate = nullptr;
  if (storage_) {
    film_.storage(in, H0, storage_rate_.data());
    for (int n = 0; n < size_; ++n) storage_rate_[n] = shift_ * (storage_rate_[n] - storage_[n]);
    rate = storage_rate_.data();
  }
  film_.residual(in, H0, {rate, shift_}, out);
  const double carried = carried_by(in);
  if (has_scalar_) out[size_] = load_row(H0, carried);
}

double StationaryNewton::load_row(double H0, double carried) const {
  return load_weight_ * (fixed() ? H0 - load_.value : (load_.value - carried) / load_.value);
}

double StationaryNewton::load_row_change(double change_H0, double change_carried) const {
  return load_weight_ * (fixed() ? change_H0 : -change_carried / load_.value);
}

// At the state of the last residual: a line search ends with the accepted one.
void StationaryNewton::update_jacobian() {
  film_.linearise(shift_);
  if (fixed()) {
    std::fill(column_solution_.begin(), column_solution_.end(), 0.0);
  } else {
    film_.precondition(film_.film_shift().data(), column_solution_.data());
  }
  schur_ = load_row_change(1.0, -carried_by(column_solution_.data()));
}

void StationaryNewton::multiply(Vec change, Vec rows) {
  const VecReading in(change);
  const VecWriting out(rows);
  const double change_H0 = broadcast(has_scalar_ ? in[size_] : 0.0);
  film_.multiply(in, change_H0, out);
  const double carried = carried_by(in);
  if (has_scalar_) out[size_] = load_row_change(change_H0, carried);
}

// With z = M^-1 r and y = M^-1 dG/dH_0: v = z - y dH_0, and the load row gives dH_0.
void StationaryNewton::precondition(Vec residual, Vec change) {
  const VecReading in(residual);
  const VecWriting out(change);
  film_.precondition(in, out);
  const double load_residual = broadcast(has_scalar_ ? in[size_] : 0.0);
  const double change_H0 = (load_residual - load_row_change(0.0, carried_by(out))) / schur_;
  for (int n = 0; n < size_; ++n) out[n] -= change_H0 * column_solution_[n];
  if (has_scalar_) out[size_] = change_H0;
}

bool StationaryNewton::solve(const LoadCondition& load, FilmSolution& guess, double shift, const double* storage) {
  load_ = load;
  shift_ = shift;
  storage_ = storage;
  {
    const VecWriting values(state_);
    std::copy_n(guess.pressure.data(), size_, static_cast<double*>(values));
    if (has_scalar_) values[size_] = guess.H0;
  }
  const long before = film_.convolutions();
  petsc_check(SNESSolve(snes_, nullptr, state_));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  PetscInt newton = 0, krylov = 0;
  petsc_check(SNESGetConvergedReason(snes_, &reason));
  petsc_check(SNESGetIterationNumber(snes_, &newton));
  petsc_check(SNESGetLinearSolveIterations(snes_, &krylov));
  PetscReal norm = 0.0;
  petsc_check(SNESGetFunctionNorm(snes_, &norm));
  counts_.newton += newton;
  counts_.krylov += krylov;
  counts_.convolutions += film_.convolutions() - before;
  counts_.residual = norm / load_weight_;
  {
    const VecReading values(state_);
    std::copy_n(static_cast<const double*>(values), size_, guess.pressure.data());
    guess.H0 = broadcast(has_scalar_ ? values[size_] : 0.0);
  }
  return reason > 0;
}

}  // namespace gearfilm

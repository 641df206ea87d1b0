// Where squeezing is stiff: a linearised film in single precision does not solve it, and a contact's film knows that.
#include "film_case.hpp"

namespace gearfilm {
namespace {

/// Newton's method for an implicit step under a given force, as StationaryNewton has it, but for products and
/// preconditioner: those are always in one precision.
class NewtonInOnePrecision final : public LinearisedSystem {
public:
  NewtonInOnePrecision(ContactFilm& film, double force, const ImplicitStep& step, Precision precision)
      : film_(film),
        force_(force),
        step_(step),
        system_({&film}, load_balance(force, 1)),
        linearised_(make_linearised_film(*film.discretisation(), {.precision = precision})),
        column_(film.grid().local_size()),
        response_(film.grid().local_size()),
        residual_(system_.create_state()),
        rate_(system_.create_state()),
        jacobian_(shell_jacobian(*this)) {
    petsc_check(SNESCreate(comm(), snes_.put()));
    petsc_check(SNESSetFunction(
        snes_, residual_,
        [](SNES, Vec state, Vec rows, void* context) -> PetscErrorCode {
          return petsc_callback([&] { static_cast<NewtonInOnePrecision*>(context)->evaluate(state, rows); });
        },
        this));
    petsc_check(SNESSetJacobian(
        snes_, jacobian_, jacobian_,
        [](SNES, Vec, Mat matrix, Mat, void* context) -> PetscErrorCode {
          return petsc_callback([&] {
            static_cast<NewtonInOnePrecision*>(context)->linearise();
            petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
            petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
          });
        },
        this));
    configure_newton(snes_, *this, NewtonOptions{}, system_.weight());
  }

  bool solve(const FilmSolution& guess) {
    const OwnedVec state = system_.create_state();
    system_.set_field(state, 0, guess.pressure);
    system_.set_scalars(state, std::span(&guess.H0, 1));
    petsc_check(SNESSolve(snes_, nullptr, state));
    SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
    petsc_check(SNESGetConvergedReason(snes_, &reason));
    return reason > 0;
  }

  /// Last root mean square.
  double residual() const {
    PetscReal norm = 0.0;
    petsc_check(SNESGetFunctionNorm(snes_, &norm));
    return norm / system_.weight();
  }

  MPI_Comm comm() const override { return system_.comm(); }
  PetscInt local_size() const override { return system_.local_size(); }
  PetscInt pressure_count() const override { return system_.pressure_count(); }

  void multiply(Vec change, Vec rows) override {
    const std::vector<double> pressure = system_.field(change, 0);
    const double H0 = system_.scalars(change).front();
    std::vector<double> film_rows(pressure.size());
    linearised_->multiply(pressure, film_rows);
    for (std::size_t n = 0; n < film_rows.size(); ++n) film_rows[n] += H0 * column_[n];
    const double force_row = -system_.weight() * integral(film_.grid(), pressure) / force_;
    system_.set_field(rows, 0, film_rows);
    system_.set_scalars(rows, std::span(&force_row, 1));
  }

  // H_0 from the force of z - y H_0, z = M^-1 rows, y = M^-1 dG/dH_0.
  void precondition(Vec rows, Vec change) override {
    std::vector<double> pressure(column_.size());
    linearised_->apply(system_.field(rows, 0), pressure);
    const double missing = system_.scalars(rows).front() / system_.weight() * force_;
    const double H0 = (integral(film_.grid(), pressure) + missing) / integral(film_.grid(), response_);
    for (std::size_t n = 0; n < pressure.size(); ++n) pressure[n] -= H0 * response_[n];
    system_.set_field(change, 0, pressure);
    system_.set_scalars(change, std::span(&H0, 1));
  }

private:
  void evaluate(Vec state, Vec rows) {
    system_.transient(state, rate_);
    std::vector<double> rate = system_.field(rate_, 0);
    for (std::size_t n = 0; n < rate.size(); ++n) rate[n] = step_.shift * (rate[n] - step_.mass[n]);
    system_.set_field(rate_, 0, rate);
    system_.residual(state, {rate_, step_.shift}, rows);
  }

  /// At the state that was evaluated last, which is where Newton's method stands.
  void linearise() {
    linearised_->update(film_.state(), step_.shift);
    linearised_->displacement_column(column_);
    linearised_->apply(column_, response_);
  }

  ContactFilm& film_;
  double force_;
  ImplicitStep step_;
  FilmSystem system_;
  std::unique_ptr<LinearisedFilm> linearised_;
  std::vector<double> column_, response_;
  OwnedVec residual_, rate_;
  OwnedMat jacobian_;
  OwnedSNES snes_;
};

// Under a given force H_0 and pressures change so that hardly any oil moves: large terms cancel. In single precision
// the error of the deformation, 1e-7 of it, times the shift is left over: FGMRES believes that a change leaves 5 % of
// the residual, and it leaves fifty times the residual.
TEST(StiffStep, converges_though_it_would_not_in_single_precision) {
  constexpr double shift_over_wedge = 2500.0;
  const FilmCase pitch = table3_pitch();
  SolvedFilm solved(PETSC_COMM_WORLD, pitch, 65, 33, {}, Edge::symmetry, FilmDiscretisation::central);
  const FilmSolution& still = solved.result.solution;
  std::vector<double> mass(still.pressure.size());
  solved.film.mass(still.pressure, still.H0, mass);
  const ImplicitStep step{shift_over_wedge / solved.grid.h_x(), mass};
  EXPECT_EQ(MultigridOptions{}.precision, Precision::single_precision);  // as the film is ordered
  // What is left over in single precision is round-off: by chance an iteration may get past it.
  int failed = 0;
  for (const double relieved : {0.6e-4, 0.8e-4, 1e-4, 1.2e-4}) {
    const double force = (1.0 - relieved) * pitch.scales.static_force;
    FilmSolution after = still;
    StationaryNewton newton({&solved.film}, NewtonOptions{});
    EXPECT_TRUE(newton.solve(LoadCondition::force(force), after, step)) << relieved;
    const auto solve_in = [&](Precision precision) {
      ContactFilm film(solved.film.discretisation(), pitch.scales, MultigridOptions{});
      NewtonInOnePrecision own(film, force, step, precision);
      const bool converged = own.solve(still);
      report("in %s precision: residual %.1e", precision == Precision::single_precision ? "single" : "double",
             own.residual());
      return converged;
    };
    EXPECT_TRUE(solve_in(Precision::double_precision)) << relieved;
    failed += solve_in(Precision::single_precision) ? 0 : 1;
  }
  EXPECT_GE(failed, 1);
}

// Below, single precision serves, and is kept as ordered.
TEST(StiffStep, has_products_in_double_precision_from_eight_times_the_wedge_on) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_WORLD, pitch.shape(65, 33));
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  move_surfaces(film, away_from_pitch());
  std::vector<double> pressure(grid.local_size()), product(grid.local_size());
  hertz_pressure(grid, pitch.scales, pitch.scales.hertz, pressure);
  const std::vector<double> still(grid.local_size(), 0.0);
  const auto exact = make_linearised_film(*film.discretisation(), {.precision = Precision::double_precision});
  const auto error_at = [&](double shift_over_wedge) {
    const double shift = shift_over_wedge * film.conditions().entrainment / grid.h_x();
    film.linearise(pressure, -pitch.scales.approach, {still, shift}, shift);
    film.multiply(pressure, 0.0, product);
    exact->update(film.state(), shift);
    std::vector<double> expected(product.size());
    exact->multiply(pressure, expected);
    return relative_difference(whole_of(grid, product), whole_of(grid, expected));
  };
  EXPECT_GT(error_at(7.9), 1e-9);   // 6e-8 is one rounding
  EXPECT_LT(error_at(8.1), 1e-15);  // the same arithmetic
  EXPECT_GT(error_at(7.9), 1e-9);   // and back
}

}  // namespace
}  // namespace gearfilm

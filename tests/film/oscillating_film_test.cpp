// The film that oscillates: the linearised film at a complex rate, and its relaxation where oil carries waves along.
#include "film/oscillating_film.hpp"

#include <algorithm>

#include "film/face_flow.hpp"
#include "film_case.hpp"
#include "numerics/newton.hpp"

namespace gearfilm {
namespace {

using Complex = std::complex<double>;

/// A film of its own at rest, linearised in double precision.
struct FilmAtRest {
  FilmAtRest(const FilmCase& contact, int nx, int ny) : solved(PETSC_COMM_WORLD, contact, nx, ny, in_double()) {
    solved.film.linearise(solved.result.solution.pressure, solved.result.solution.H0, {}, 0.0);
  }

  static SolverOptions in_double() {
    SolverOptions options;
    options.multigrid.precision = Precision::double_precision;
    return options;
  }

  SolvedFilm solved;
};

/// (A + s B) p = a + s b, preconditioned by one relaxation.
class RelaxedFilm final : public LinearisedSystem {
public:
  RelaxedFilm(FilmAtRest& rest, Complex s) : film_(rest.solved.film), oscillating_(*rest.solved.film.discretisation()) {
    oscillating_.update(film_.state(), s);
  }

  MPI_Comm comm() const override { return film_.grid().comm(); }
  PetscInt local_size() const override { return 2 * film_.grid().local_size(); }
  PetscInt pressure_count() const override { return local_size(); }
  void multiply(Vec change, Vec rows) override {
    oscillating_.multiply(VecReading(change).values(), VecWriting(rows).values());
  }
  void precondition(Vec rows, Vec change) override {
    oscillating_.relax(VecReading(rows).values(), VecWriting(change).values());
  }

  /// Iterations of FGMRES until 1e-8; 400 where it does not come there.
  PetscInt iterations() {
    const OwnedMat matrix = shell_jacobian(*this);
    OwnedKSP solver;
    petsc_check(KSPCreate(comm(), solver.put()));
    configure_krylov(solver, *this, 1e-8, 400);
    petsc_check(KSPSetErrorIfNotConverged(solver, PETSC_FALSE));
    petsc_check(KSPSetOperators(solver, matrix, matrix));
    OwnedVec column, change;
    petsc_check(MatCreateVecs(matrix, change.put(), column.put()));
    oscillating_.displacement_column(VecWriting(column).values());
    petsc_check(KSPSolve(solver, column, change));
    PetscInt count = 0;
    petsc_check(KSPGetIterationNumber(solver, &count));
    return count;
  }

private:
  ContactFilm& film_;
  OscillatingFilm oscillating_;
};

TEST(OscillatingFilm, is_the_linearised_film_at_a_complex_rate) {
  FilmAtRest rest(table3_pitch(), 65, 33);
  ContactFilm& film = rest.solved.film;
  const Complex s(-1.5, 20.0);
  film.set_rates_in_wedge(rates_in_wedge(0.0));
  film.linearise(rest.solved.result.solution.pressure, rest.solved.result.solution.H0, {}, 0.0);
  OscillatingFilm oscillating(*film.discretisation());
  oscillating.update(film.state(), s);
  const std::size_t size = film.grid().local_size();
  std::vector<double> change(2 * size), rows(2 * size), column(2 * size);
  for (std::size_t n = 0; n < 2 * size; ++n) change[n] = std::sin(0.7 * static_cast<double>(n));
  oscillating.multiply(change, rows);
  oscillating.displacement_column(column);
  std::vector<double> still[2], moving[2], moved(size), nothing(size, 0.0);
  for (const std::size_t part : {0, 1}) {
    still[part].resize(size);
    moving[part].resize(size);
    film.multiply(std::span(change).subspan(part * size, size), 0.0, still[part]);
    film.multiply_mass(std::span(change).subspan(part * size, size), 0.0, moving[part]);
  }
  film.multiply_mass(nothing, 1.0, moved);
  double scale = 0.0;
  for (const double row : rows) scale = std::max(scale, std::abs(row));
  for (std::size_t n = 0; n < size; ++n) {
    const Complex row = Complex(still[0][n], still[1][n]) + s * Complex(moving[0][n], moving[1][n]);
    const Complex by_displacement = film.displacement_column()[n] + s * moved[n];
    ASSERT_NEAR(rows[n], row.real(), 1e-12 * scale);
    ASSERT_NEAR(rows[size + n], row.imag(), 1e-12 * scale);
    ASSERT_NEAR(column[n], by_displacement.real(), 1e-10 * std::abs(s));
    ASSERT_NEAR(column[size + n], by_displacement.imag(), 1e-10 * std::abs(s));
  }
}

// A nearly line contact of a slow pair's thin film. Up to 15 waves are in the contact at a time, in which the oil
// leaves with what film it was given: bands that do not know them leave FGMRES where it is.
TEST(OscillatingFilm, relaxation_solves_for_waves_that_oil_carries) {
  FilmAtRest rest(moes_contact(2e4, 8.0, 0.003), 257, 49);
  for (const double rate : {5.0, 20.0, 50.0}) {
    const PetscInt count = RelaxedFilm(rest, Complex(-0.01 * rate, rate)).iterations();
    report("rate %g: %d iterations", rate, static_cast<int>(count));
    EXPECT_LT(count, 120);
  }
}

}  // namespace
}  // namespace gearfilm

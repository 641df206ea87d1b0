// The multigrid preconditioner of the linearised film: contraction, and independence of the number of processes.
#include "gearfilm/ehl/preconditioner.hpp"

#include <tuple>

#include "film_case.hpp"

namespace gearfilm {
namespace {

const char* name_of(Precision precision) { return precision == Precision::single_precision ? "single" : "double"; }

/// A film linearised about the converged Table 3 film on 65 x 33, and a linear solver for it.
class LinearisedFilm {
public:
  LinearisedFilm(MPI_Comm comm, int levels, Precision precision)
      : grid(comm, contact.shape(65, 33)), film(grid, contact.scales, {.levels = levels, .precision = precision}) {
    const FilmSolution& solution = table3_film_65x33();
    std::vector<double> residual(grid.local_size());
    film.residual(own_part(grid, solution.pressure).data(), solution.H0, nullptr, residual.data());
    film.linearise(0.0);
  }

  /// White noise inside, zero on the boundary; compact.
  std::vector<double> right_side() const {
    std::vector<double> values(grid.local_size(), 0.0);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (!grid.is_boundary(i, j)) values[i * grid.y_count() + j] = noise(i, grid.y_begin() + j);
      }
    }
    return values;
  }

  /// Iterations of FGMRES to 1e-10 of the right side's norm; -1 where it does not get there.
  int iterations_to_1e10();

  FilmCase contact = table3_pitch();
  Grid grid;
  ContactFilm film;
};

int LinearisedFilm::iterations_to_1e10() {
  OwnedMat matrix;
  const PetscInt size = grid.local_size();
  petsc_check(MatCreateShell(grid.comm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, &film, matrix.put()));
  const auto multiply = +[](Mat mat, Vec in, Vec out) -> PetscErrorCode {
    return petsc_callback([&] {
      ContactFilm* own = nullptr;
      petsc_check(MatShellGetContext(mat, &own));
      own->multiply(VecReading(in), 0.0, VecWriting(out));
    });
  };
  petsc_check(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  OwnedKSP solver;
  petsc_check(KSPCreate(grid.comm(), solver.put()));
  petsc_check(KSPSetType(solver, KSPFGMRES));
  petsc_check(KSPGMRESSetRestart(solver, 200));
  petsc_check(KSPSetTolerances(solver, 1e-10, 0.0, PETSC_DEFAULT, 200));
  petsc_check(KSPSetOperators(solver, matrix, matrix));
  PC pc = nullptr;
  petsc_check(KSPGetPC(solver, &pc));
  petsc_check(PCSetType(pc, PCSHELL));
  petsc_check(PCShellSetContext(pc, &film));
  petsc_check(PCShellSetApply(pc, [](PC shell, Vec in, Vec out) -> PetscErrorCode {
    return petsc_callback([&] {
      ContactFilm* own = nullptr;
      petsc_check(PCShellGetContext(shell, &own));
      own->precondition(VecReading(in), VecWriting(out));
    });
  }));
  OwnedVec right = grid.create_vec(), solution = grid.create_vec();
  const auto values = right_side();
  std::copy(values.begin(), values.end(), static_cast<double*>(VecWriting(right)));
  petsc_check(KSPSolve(solver, right, solution));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  petsc_check(KSPGetConvergedReason(solver, &reason));
  petsc_check(KSPGetIterationNumber(solver, &iterations));
  return reason > 0 ? static_cast<int>(iterations) : -1;
}

class Preconditioner : public testing::TestWithParam<std::tuple<int, Precision>> {};

TEST_P(Preconditioner, contracts_alike_on_any_number_of_processes) {
  const auto [levels, precision] = GetParam();
  LinearisedFilm distributed(PETSC_COMM_WORLD, levels, precision);
  LinearisedFilm alone(PETSC_COMM_SELF, levels, precision);
  const int iterations = distributed.iterations_to_1e10();
  const int iterations_alone = alone.iterations_to_1e10();
  report(std::to_string(levels) + " levels, " + name_of(precision) + " precision: " + std::to_string(iterations) +
         " iterations, alone " + std::to_string(iterations_alone));
  ASSERT_GT(iterations, 0);
  // Round-off differs by the order of sums: it may tip one iteration.
  EXPECT_NEAR(iterations, iterations_alone, 1);
}

// Where levels are gathered on every process, and where they are not, it is the same cycle.
TEST_P(Preconditioner, gives_the_same_change_on_any_number_of_processes) {
  const auto [levels, precision] = GetParam();
  LinearisedFilm distributed(PETSC_COMM_WORLD, levels, precision);
  LinearisedFilm alone(PETSC_COMM_SELF, levels, precision);
  std::vector<double> change(distributed.grid.local_size()), change_alone(alone.grid.local_size());
  distributed.film.precondition(distributed.right_side().data(), change.data());
  alone.film.precondition(alone.right_side().data(), change_alone.data());
  // Round-off of a single (6e-8) or double (1e-16) arithmetic, amplified by the lines' condition.
  const double tolerance = precision == Precision::single_precision ? 1e-5 : 1e-12;
  const double difference = relative_difference(whole_of(distributed.grid, change), change_alone);
  char text[100];
  std::snprintf(text, sizeof text, "%d levels, %s precision: changes differ by %.1e", levels, name_of(precision),
                difference);
  report(text);
  EXPECT_LT(difference, tolerance);
}

INSTANTIATE_TEST_SUITE_P(levels_and_precisions, Preconditioner,
                         testing::Combine(testing::Range(1, 6),
                                          testing::Values(Precision::single_precision, Precision::double_precision)),
                         [](const auto& info) {
                           return std::to_string(std::get<0>(info.param)) + "_levels_" + name_of(std::get<1>(info.param));
                         });

}  // namespace
}  // namespace gearfilm

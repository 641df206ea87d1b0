// The multigrid preconditioner of the linearised film: contraction, and independence of the number of processes.
#include "film/linearised_film.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "film_case.hpp"
#include "numerics/newton.hpp"

namespace gearfilm {
namespace {

const char* name_of(Precision precision) { return precision == Precision::single_precision ? "single" : "double"; }

/// A film linearised about the converged Table 3 film, and a linear solver for it.
class FilmOperator final : public LinearisedSystem {
public:
  FilmOperator(MPI_Comm comm, const FilmSolution& solution, int nx, int ny, const MultigridOptions& options,
               double shift)
      : grid(comm, contact.shape(nx, ny)), film(discretise(grid, contact.scales), contact.scales, options) {
    move_surfaces(film, away_from_pitch());
    film.linearise(own_part(grid, solution.pressure), solution.H0, {}, shift);
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

  MPI_Comm comm() const override { return grid.comm(); }
  PetscInt local_size() const override { return grid.local_size(); }
  PetscInt pressure_count() const override { return local_size(); }
  void multiply(Vec change, Vec rows) override {
    film.multiply(VecReading(change).values(), 0.0, VecWriting(rows).values());
  }
  void precondition(Vec rows, Vec change) override {
    film.precondition(VecReading(rows).values(), VecWriting(change).values());
  }

  /// Norms of the residual of FGMRES over that of the right side, until 1e-10.
  std::vector<double> convergence();

  FilmCase contact = table3_pitch();
  Grid grid;
  ContactFilm film;
};

std::vector<double> FilmOperator::convergence() {
  const OwnedMat matrix = shell_jacobian(*this);
  OwnedKSP solver;
  petsc_check(KSPCreate(grid.comm(), solver.put()));
  configure_krylov(solver, *this, 1e-10, 200);
  petsc_check(KSPSetOperators(solver, matrix, matrix));
  OwnedVec right = grid.create_vec(), solution = grid.create_vec();
  const auto values = right_side();
  std::ranges::copy(values, VecWriting(right).values().begin());
  petsc_check(KSPSetResidualHistory(solver, nullptr, 201, PETSC_TRUE));
  petsc_check(KSPSolve(solver, right, solution));
  const PetscReal* norms = nullptr;
  PetscInt count = 0;
  petsc_check(KSPGetResidualHistory(solver, &norms, &count));
  std::vector<double> history(norms, norms + count);
  for (double& norm : history) norm /= norms[0];
  return history;
}

/// Iterations until a residual history reaches a tolerance; -1 where it does not.
int iterations_to(double tolerance, const std::vector<double>& history) {
  const auto reached = std::find_if(history.begin(), history.end(), [&](double norm) { return norm <= tolerance; });
  return reached == history.end() ? -1 : static_cast<int>(reached - history.begin());
}

class Preconditioner : public testing::TestWithParam<std::tuple<int, Precision>> {
protected:
  static const FilmSolution& solution() {
    static const FilmSolution solved = film_away_from_pitch(65, 33);
    return solved;
  }
  static MultigridOptions options() {
    return {.levels = std::get<0>(GetParam()), .precision = std::get<1>(GetParam())};
  }
  // Of a time step, so that no level can forget it.
  static constexpr double shift = 5.0;
  FilmOperator distributed{PETSC_COMM_WORLD, solution(), 65, 33, options(), shift};
  FilmOperator alone{PETSC_COMM_SELF, solution(), 65, 33, options(), shift};
};

TEST_P(Preconditioner, contracts_alike_on_any_number_of_processes) {
  const auto [levels, precision] = GetParam();
  const int iterations = iterations_to(1e-10, distributed.convergence());
  const int iterations_alone = iterations_to(1e-10, alone.convergence());
  report("%d levels, %s precision: %d iterations to 1e-10, alone %d", levels, name_of(precision), iterations,
         iterations_alone);
  // 5-8 V-cycles per factor 1e-3 are known to be possible; the smoother alone needs about twice as many.
  EXPECT_GT(iterations, 0);
  EXPECT_LE(iterations, levels == 1 ? 50 : 27);
  // Round-off differs by the order of sums: it may tip one iteration.
  EXPECT_NEAR(iterations, iterations_alone, 1);
}

// Where levels are gathered on every process, and where they are not, it is the same cycle.
TEST_P(Preconditioner, gives_the_same_change_on_any_number_of_processes) {
  std::vector<double> change(distributed.grid.local_size()), change_alone(alone.grid.local_size());
  distributed.film.precondition(distributed.right_side(), change);
  alone.film.precondition(alone.right_side(), change_alone);
  // Round-off of a single (6e-8) or double (1e-16) arithmetic, amplified by the lines' condition.
  const double tolerance = std::get<1>(GetParam()) == Precision::single_precision ? 1e-5 : 1e-12;
  EXPECT_LT(relative_difference(whole_of(distributed.grid, change), change_alone), tolerance);
}

// A cavitated row is d v = r, known as soon as it is relaxed: its node takes nothing from coarser levels.
TEST_P(Preconditioner, solves_cavitated_rows) {
  const auto right_side = distributed.right_side();
  std::vector<double> change(right_side.size()), rows(right_side.size());
  distributed.film.precondition(right_side, change);
  distributed.film.multiply(change, 0.0, rows);
  const double tolerance = std::get<1>(GetParam()) == Precision::single_precision ? 1e-6 : 1e-14;
  const auto pressure = own_part(distributed.grid, solution().pressure);
  int cavitated = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (std::abs(pressure[n]) > 1e-12) continue;
    EXPECT_NEAR(rows[n], right_side[n], tolerance);
    cavitated += right_side[n] != 0.0;
  }
  MPI_Allreduce(MPI_IN_PLACE, &cavitated, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_GT(cavitated, 100);
}

TEST_P(Preconditioner, has_the_levels_asked_for) {
  EXPECT_EQ(make_linearised_film(*distributed.film.discretisation(), options())->levels(), std::get<0>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(levels_and_precisions, Preconditioner,
                         testing::Combine(testing::Range(1, 6),
                                          testing::Values(Precision::single_precision, Precision::double_precision)),
                         [](const auto& parameters) {
                           return std::to_string(std::get<0>(parameters.param)) + "_levels_" +
                                  name_of(std::get<1>(parameters.param));
                         });

class PreconditionerLevels : public testing::Test {
protected:
  static int levels_of(const FilmCase& contact, int nx, int ny, double longest_step = HUGE_VAL, bool keep_rows = true) {
    const SharedDiscretisation shared = discretise(Grid(PETSC_COMM_WORLD, contact.shape(nx, ny)), contact.scales);
    return make_linearised_film(*shared, {.keep_rows = keep_rows}, longest_step)->levels();
  }

  FilmCase slender = table3_pitch();                 // cells eight times as long as wide on twice as many lines as rows
  FilmCase circular = moes_contact(200, 10, 1.0);    // cells almost square on as many
  FilmCase needle = moes_contact(20000, 10, 0.004);  // cells twenty times as long as wide on as many
};

TEST_F(PreconditionerLevels, go_down_to_33_lines_where_cells_are_long_whatever_the_rows) {
  EXPECT_EQ(levels_of(slender, 65, 33), 2);
  EXPECT_EQ(levels_of(slender, 129, 9), 3);
  EXPECT_EQ(levels_of(slender, 257, 65), 4);
  EXPECT_EQ(levels_of(slender, 265, 33), 4);  // 34 lines are even
}

TEST_F(PreconditionerLevels, go_down_to_33_nodes_along_either_direction_where_cells_are_square) {
  EXPECT_EQ(levels_of(circular, 65, 65), 2);
  EXPECT_EQ(levels_of(circular, 257, 257), 4);
  EXPECT_EQ(levels_of(circular, 65, 257), 4);  // the last ones across alone
  EXPECT_EQ(levels_of(circular, 37, 41), 1);
}

TEST_F(PreconditionerLevels, go_down_to_33_nodes_along_either_direction_where_rows_need_not_be_kept) {
  EXPECT_EQ(levels_of(slender, 129, 17, HUGE_VAL, false), 3);  // along X alone
  EXPECT_EQ(levels_of(slender, 65, 257, HUGE_VAL, false), 4);  // 65 x 257, 33 x 129, 33 x 65, 33 x 33
  EXPECT_EQ(levels_of(needle, 129, 129, HUGE_VAL, false), 3);  // 65 x 65, 33 x 33
  EXPECT_EQ(levels_of(needle, 129, 129, HUGE_VAL, true), 4);   // 65 x 129, 33 x 129, 33 x 65
}

TEST_F(PreconditionerLevels, are_no_coarser_than_the_longest_step) {
  const double h_x = slender.shape(257, 65).h_x();
  EXPECT_EQ(levels_of(slender, 257, 65, 4.01 * h_x), 4);  // 129 x 65, 65 x 65, 65 x 33
  EXPECT_EQ(levels_of(slender, 257, 65, 0.5 * h_x), 1);
}

TEST_F(PreconditionerLevels, are_the_same_on_any_number_of_processes) {
  for (const auto& [nx, ny] : {std::pair{129, 17}, {129, 129}, {257, 257}}) {
    for (const FilmCase& contact : {slender, circular}) {
      const SharedDiscretisation alone = discretise(Grid(PETSC_COMM_SELF, contact.shape(nx, ny)), contact.scales);
      EXPECT_EQ(levels_of(contact, nx, ny), make_linearised_film(*alone, MultigridOptions{})->levels());
    }
  }
}

// A finer grid's white noise takes longer to become smooth; from then on the grid hardly matters.
TEST(SlowPreconditioner, needs_at_most_8_iterations_per_factor_1000_on_any_grid) {
  for (const auto& [nx, ny] : {std::pair{65, 33}, {129, 65}, {257, 129}, {129, 129}}) {
    const FilmSolution solution = film_away_from_pitch(nx, ny);
    for (const double shift : {0.0, 30.0}) {
      FilmOperator film(PETSC_COMM_WORLD, solution, nx, ny, MultigridOptions{}, shift);
      const auto history = film.convergence();
      const int first = iterations_to(1e-3, history), all = iterations_to(1e-10, history);
      const double per_factor_1000 = (all - first) * 3.0 / 7.0;
      report("%3d x %-3d shift %2.0f: %2d iterations to 1e-3, %2d to 1e-10, then %.1f per factor 1e-3", nx, ny, shift,
             first, all, per_factor_1000);
      EXPECT_GT(first, 0);
      EXPECT_LE(first, 18);
      EXPECT_GT(per_factor_1000, 0.0);
      EXPECT_LE(per_factor_1000, 8.0);
    }
  }
}

}  // namespace
}  // namespace gearfilm

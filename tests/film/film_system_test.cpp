// Two films on bodies with three scalars, which displace the films and feel their forces each in its own way: rest, a
// time step, the Jacobian, and the elimination of scalars.
#include "solver/film_system.hpp"

#include "algebra/dense.hpp"
#include "film_case.hpp"

namespace gearfilm {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const MatrixXd displacement_of_films{{1.0, 0.3, 0.0}, {0.2, 1.0, 0.0}};  // B
constexpr double mass_of_first = 3.0, spring_between = 5.0;

/// s = (q_1, q_2, v_1): two bodies, of which the first has a mass, a spring between them, and loads L_i, which are the
/// given part of those under which both films carry the static force F*.
///   dq_1/dT - v_1 = 0 ,   (k (q_2 - q_1) + L_2 - 0.3 F_1 - F_2)/F* = 0 ,
///   (m dv_1/dT + k (q_1 - q_2) + L_1 - F_1 - 0.2 F_2)/F* = 0
BodyEquations two_bodies(double static_force, double load) {
  const double m = mass_of_first / static_force, k = spring_between / static_force;
  MatrixXd force = MatrixXd::Zero(3, 2);
  force.row(1) = displacement_of_films.col(1).transpose() / static_force;
  force.row(2) = displacement_of_films.col(0).transpose() / static_force;
  return {.mass = MatrixXd{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, m}},
          .stiffness = MatrixXd{{0.0, 0.0, -1.0}, {-k, k, 0.0}, {k, -k, 0.0}},
          .constant = load * static_force * force.rowwise().sum(),
          .force = force,
          .displacement = displacement_of_films};
}

/// A force that grows as the bodies approach each other.
ReverseFlankForce between_bodies(double static_force) {
  const auto law = [static_force](double approach) {
    const double force = 0.1 * static_force * std::exp(approach);
    return ReverseFlankForce::Value{force, force};
  };
  return {law, Eigen::RowVector3d(-0.5, 0.4, 0.0), Eigen::Vector3d(0.0, 0.4, -0.5) / static_force};
}

void assemble(Mat matrix) {
  petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

class TwoFilms : public testing::TestWithParam<const char*> {
protected:
  TwoFilms() {
    move_surfaces(away, away_from_pitch());
    // Each film by itself under the static force.
    VectorXd H(2);
    for (int k = 0; k < 2; ++k) {
      const FilmSolution film =
          solve_stationary(k == 0 ? pitch : away, LoadCondition::force(static_force), SolverOptions{}).solution;
      system.set_field(state, k, film.pressure);
      H[k] = film.H0;
    }
    const VectorXd q = solved(displacement_of_films.leftCols(2),
                              H - compliance.displacements(VectorXd::Zero(2), VectorXd::Constant(2, static_force)));
    system.set_scalars(state, std::array{q[0], q[1], 0.0});
  }

  /// Loads, as a part of those of two_bodies().
  void load(double part) {
    system.set_bodies(two_bodies(static_force, part), compliance, between_bodies(static_force));
  }

  /// From now on states are those at the end of an implicit step of 1/shift from the present one.
  void begin_step(double step_shift) {
    shift = step_shift;
    history = system.create_state();
    system.transient(state, history);
  }

  FilmSystem::Rate rate_at(Vec at) {
    if (shift == 0.0) return {};
    system.transient(at, rate);
    petsc_check(VecAXPY(rate, -1.0, history));
    petsc_check(VecScale(rate, shift));
    return {rate, shift};
  }
  void linearise(Vec at, FilmSystem::BlockElimination by) { system.linearise(at, rate_at(at), shift, by); }
  OwnedVec rows_at(Vec at) {
    OwnedVec rows = system.create_state();
    system.residual(at, rate_at(at), rows);
    return rows;
  }

  /// Newton's method from the present state.
  bool solve(FilmSystem::BlockElimination by = FilmSystem::BlockElimination::exact) {
    elimination = by;
    const OwnedVec residual = system.create_state();
    const OwnedMat jacobian = shell_jacobian(system);
    OwnedSNES snes;
    petsc_check(SNESCreate(PETSC_COMM_WORLD, snes.put()));
    petsc_check(SNESSetFunction(
        snes, residual,
        [](SNES, Vec at, Vec rows, void* context) -> PetscErrorCode {
          auto& own = *static_cast<TwoFilms*>(context);
          return petsc_callback([&] { own.system.residual(at, own.rate_at(at), rows); });
        },
        this));
    petsc_check(SNESSetJacobian(
        snes, jacobian, jacobian,
        [](SNES, Vec at, Mat matrix, Mat, void* context) -> PetscErrorCode {
          auto& own = *static_cast<TwoFilms*>(context);
          return petsc_callback([&] {
            own.linearise(at, own.elimination);
            assemble(matrix);
          });
        },
        this));
    configure_newton(snes, system, NewtonOptions{.tolerance = 1e-9}, system.weight());
    petsc_check(SNESSolve(snes, nullptr, state));
    SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
    petsc_check(SNESGetConvergedReason(snes, &reason));
    return reason > 0;
  }

  VectorXd scalars_of(Vec of) const {
    const std::vector<double> scalars = system.scalars(of);
    return Eigen::Map<const VectorXd>(scalars.data(), static_cast<Eigen::Index>(scalars.size()));
  }

  VectorXd film_forces() {
    const std::vector<FilmQuantities> quantities = system.quantities(state);
    return Eigen::Vector2d(quantities[0].pressure_integral, quantities[1].pressure_integral);
  }

  /// The equations of two_bodies() at the present state, with rates of the scalars, written again.
  void expect_balance(const VectorXd& s, const VectorXd& rates, double part) {
    const VectorXd F = film_forces();
    const double back = 0.1 * static_force * std::exp(-0.5 * s[0] + 0.4 * s[1]);
    const double on_first = part * 1.2 * static_force + spring_between * (s[0] - s[1]) - F[0] - 0.2 * F[1] - 0.5 * back;
    const double on_second =
        part * 1.3 * static_force + spring_between * (s[1] - s[0]) - 0.3 * F[0] - F[1] + 0.4 * back;
    const double allowed = 1e-6 * static_force;  // the tolerance of Newton's method weighs one row among all nodes
    EXPECT_NEAR(rates[0], s[2], 1e-6);
    EXPECT_NEAR(mass_of_first * rates[2] + on_first, 0.0, allowed);
    EXPECT_NEAR(on_second, 0.0, allowed);
    const VectorXd displaced = system.displacements(state);
    for (int k = 0; k < 2; ++k) {
      double expected = displacement_of_films(k, 0) * s[0] + displacement_of_films(k, 1) * s[1];
      for (int j = 0; j < 2; ++j) expected += compliance(k, j) * F[j];
      EXPECT_NEAR(displaced[k], expected, 1e-12);
    }
  }

  /// Inner nodes of a film without pressure, on the process that has most.
  double cavitated_nodes(int film) const {
    const std::vector<double> pressure = system.field(state, film);
    double count = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (!grid.is_boundary(i, j) && pressure[i * grid.y_count() + j] == 0.0) count += 1.0;
      }
    }
    return maximum(count);
  }

  /// A change of the state, small where the pressure is, so that no node changes between full and cavitated.
  OwnedVec direction(double of_pressure, const std::array<double, 3>& of_scalars) const {
    OwnedVec change = system.create_state();
    for (int k = 0; k < 2; ++k) {
      std::vector<double> field = system.field(state, k);
      for (int i = 0; i < grid.nx(); ++i) {
        for (int j = 0; j < grid.y_count(); ++j) {
          const double wave = std::sin(2.3 * grid.x(i) + 0.4 + k) * std::cos(0.6 * grid.y(j) + 0.5) +
                              0.3 * noise(i, grid.y_begin() + j, static_cast<unsigned>(k));
          field[i * grid.y_count() + j] *= of_pressure * wave;
        }
      }
      system.set_field(change, k, field);
    }
    system.set_scalars(change, of_scalars);
    return change;
  }

  FilmCase contact = table3_pitch();
  double static_force = contact.scales.static_force;
  Grid grid{PETSC_COMM_WORLD, contact.shape(65, 33)};
  MultigridOptions multigrid{.precision = Precision::double_precision};
  ContactFilm pitch{discretise(grid, contact.scales), contact.scales, multigrid};
  ContactFilm away{pitch.discretisation(), contact.scales, multigrid};
  Compliance compliance =
      GetParam() == std::string("rigid") ? Compliance() : Compliance(MatrixXd{{0.04, 0.01}, {0.01, 0.03}});
  FilmSystem system{{&pitch, &away}, two_bodies(static_force, 1.0)};
  OwnedVec state = system.create_state(), rate = system.create_state(), history;
  double shift = 0.0;
  FilmSystem::BlockElimination elimination = FilmSystem::BlockElimination::exact;
};

TEST_P(TwoFilms, come_to_rest_with_their_bodies) {
  load(1.03);
  ASSERT_TRUE(solve());
  const VectorXd s = scalars_of(state);
  expect_balance(s, VectorXd::Zero(3), 1.03);
  EXPECT_GT(std::abs(s[0] - s[1]), 0.05);
}

// With the scalars before the films, too, which takes more iterations: the second body has no mass.
TEST_P(TwoFilms, move_with_their_bodies_in_a_time_step) {
  load(1.0);
  ASSERT_TRUE(solve());
  const OwnedVec rest = system.create_state();
  petsc_check(VecCopy(state, rest));
  const VectorXd before = scalars_of(state);
  VectorXd last;
  for (const auto by : {FilmSystem::BlockElimination::exact, FilmSystem::BlockElimination::scalars_first}) {
    petsc_check(VecCopy(rest, state));
    begin_step(20.0);
    load(1.1);
    ASSERT_TRUE(solve(by));
    const VectorXd s = scalars_of(state);
    expect_balance(s, shift * (s - before), 1.1);
    EXPECT_LT(s[2], -1e-3);  // pressed together
    if (last.size() > 0) {
      EXPECT_LT((s - last).cwiseAbs().maxCoeff(), 1e-6);
    }
    last = s;
  }
}

TEST_P(TwoFilms, jacobian_passes_taylor_test) {
  load(1.0);
  ASSERT_TRUE(solve());
  begin_step(20.0);
  load(1.1);
  ASSERT_TRUE(solve());
  EXPECT_GT(cavitated_nodes(0), 0.0);
  EXPECT_GT(cavitated_nodes(1), 0.0);
  const OwnedVec slope = system.create_state(), moved = system.create_state();
  for (const OwnedVec& change :
       {direction(1.0, {0.0, 0.0, 0.0}), direction(0.0, {1e-2, -5e-3, 0.3}), direction(1.0, {-5e-3, 1e-2, -0.1})}) {
    const OwnedVec at_state = rows_at(state);
    linearise(state, FilmSystem::BlockElimination::exact);
    system.multiply(change, slope);
    EXPECT_GT(system.merit(slope), 1e-4);  // a slope of zero would pass as well
    double before = 0.0;
    for (const double step : {4e-3, 2e-3, 1e-3, 5e-4}) {
      petsc_check(VecWAXPY(moved, step, change, state));
      const OwnedVec remainder = rows_at(moved);
      petsc_check(VecAXPY(remainder, -1.0, at_state));
      petsc_check(VecAXPY(remainder, -step, slope));
      const double size = system.merit(remainder);
      if (before > 0.0) expect_rate("jacobian_taylor_remainder", std::log2(before / size));
      before = size;
    }
  }
}

/// change with J change = rows, to the digits that there are.
OwnedVec krylov_solution(FilmSystem& system, Vec rows) {
  OwnedVec change = system.create_state();
  const OwnedMat jacobian = shell_jacobian(system);
  assemble(jacobian);
  OwnedKSP ksp;
  petsc_check(KSPCreate(system.comm(), ksp.put()));
  petsc_check(KSPSetOperators(ksp, jacobian, jacobian));
  configure_krylov(ksp, system, 1e-13, 300);
  petsc_check(KSPSolve(ksp, rows, change));
  return change;
}

/// What (dG/dP)^-1 of one film makes of its rows and of dG/dH, linearised where the system is.
struct FilmInverse {
  std::vector<double> of_rows, of_displacement;
};

// The body equations see the forces of the films alone, and those of a cycle add up whatever it leaves of the films'
// rows.
TEST_P(TwoFilms, exact_elimination_fulfils_the_body_equations) {
  begin_step(20.0);
  load(1.1);
  linearise(state, FilmSystem::BlockElimination::exact);
  const OwnedVec rows = rows_at(state), change = system.create_state(), product = system.create_state();
  system.precondition(rows, change);
  system.multiply(change, product);
  const VectorXd wanted = scalars_of(rows);
  EXPECT_GT(wanted.cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT((scalars_of(product) - wanted).cwiseAbs().maxCoeff(), 1e-10 * wanted.cwiseAbs().maxCoeff());
}

// And so do scalars that come first, where no film acts on the bodies.
TEST_P(TwoFilms, scalars_first_fulfil_the_body_equations_that_know_no_film) {
  begin_step(20.0);
  BodyEquations bodies = two_bodies(static_force, 1.1);
  bodies.force.setZero();
  system.set_bodies(bodies, {}, between_bodies(static_force));
  linearise(state, FilmSystem::BlockElimination::scalars_first);
  const OwnedVec rows = rows_at(state), change = system.create_state(), product = system.create_state();
  system.precondition(rows, change);
  system.multiply(change, product);
  const VectorXd wanted = scalars_of(rows);
  EXPECT_LT((scalars_of(product) - wanted).cwiseAbs().maxCoeff(), 1e-10 * wanted.cwiseAbs().maxCoeff());
}

// (dG_k/dP_k)^-1 of either film by itself, and the equations of film_system.hpp, against the solution of the whole.
TEST_P(TwoFilms, elimination_is_exact_with_exact_films) {
  begin_step(20.0);
  load(1.1);
  const OwnedVec rows = rows_at(state);
  const VectorXd displaced = system.displacements(state);
  const FilmSystem::Rate now = rate_at(state);
  std::array<FilmInverse, 2> films;
  VectorXd stiffness(2), force(2);
  for (int k = 0; k < 2; ++k) {
    FilmSystem alone({k == 0 ? &pitch : &away}, fixed_approach(displaced[k], 1));
    const OwnedVec at = alone.create_state(), its_rate = alone.create_state(), right = alone.create_state();
    alone.set_field(at, 0, system.field(state, k));
    alone.set_scalars(at, std::array{displaced[k]});
    alone.set_field(its_rate, 0, system.field(now.values, k));
    alone.linearise(at, {its_rate, shift}, shift, FilmSystem::BlockElimination::scalars_first);
    alone.set_field(right, 0, system.field(rows, k));
    films[k].of_rows = alone.field(krylov_solution(alone, right), 0);
    petsc_check(VecSet(right, 0.0));
    alone.set_scalars(right, std::array{-alone.weight()});  // H = -1
    films[k].of_displacement = alone.field(krylov_solution(alone, right), 0);
    force[k] = integral(grid, films[k].of_rows);
    stiffness[k] = integral(grid, films[k].of_displacement);
  }
  const MatrixXd C{{compliance(0, 0), compliance(0, 1)}, {compliance(1, 0), compliance(1, 1)}};
  const MatrixXd S = stiffness.asDiagonal(), coupled = inverse(MatrixXd::Identity(2, 2) + S * C);
  const BodyEquations bodies = two_bodies(static_force, 1.1);
  const MatrixXd schur = shift * bodies.mass + bodies.stiffness + bodies.force * coupled * S * displacement_of_films +
                         between_bodies(static_force).jacobian(scalars_of(state));
  const VectorXd s = solved(schur, scalars_of(rows) / system.weight() + bodies.force * coupled * force);
  const VectorXd F = coupled * (force - S * displacement_of_films * s), H = displacement_of_films * s + C * F;

  for (const auto by : {FilmSystem::BlockElimination::exact, FilmSystem::BlockElimination::scalars_first}) {
    linearise(state, by);
    const OwnedVec change = krylov_solution(system, rows);
    EXPECT_LT((scalars_of(change) - s).cwiseAbs().maxCoeff(), 1e-10 * s.cwiseAbs().maxCoeff());
    for (int k = 0; k < 2; ++k) {
      std::vector<double> expected = films[k].of_rows;
      for (std::size_t n = 0; n < expected.size(); ++n) expected[n] -= H[k] * films[k].of_displacement[n];
      EXPECT_LT(relative_difference(whole_of(grid, system.field(change, k)), whole_of(grid, expected)), 1e-9);
    }
  }
}

TEST(PressureLimits, are_narrow_where_oil_stiffens_much) {
  const auto expect_limits = [](double L, double rise, double fall) {
    const FilmCase contact = moes_contact(2400.0, L, 1.0);
    ContactFilm film(discretise(Grid(PETSC_COMM_WORLD, contact.shape(33, 17)), contact.scales), contact.scales, {});
    const PressureLimits limits = FilmSystem({&film}, fixed_approach(0.0, 1)).pressure_limits();
    EXPECT_NEAR(limits.rise, rise, 1e-9) << L;
    EXPECT_NEAR(limits.fall, fall, 1e-9) << L;
  };
  expect_limits(25.0, 1.0 / 25.0, 0.4);
  expect_limits(12.0, 1.0 / 12.0, 0.6);
  expect_limits(6.0, 0.1, 0.9);
}

INSTANTIATE_TEST_SUITE_P(on_solids, TwoFilms, testing::Values("rigid", "compliant"),
                         [](const auto& solids) { return std::string(solids.param); });

}  // namespace
}  // namespace gearfilm

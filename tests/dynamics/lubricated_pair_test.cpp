// Films and motion as one system: its Jacobian, its preconditioner, and the time scheme it is solved for.
#include "accepted_steps.hpp"
#include "dynamics/slope_weights.hpp"

namespace gearfilm {
namespace {

/// Two contacts in motion, a few steps of 0.05 after the start: on rigid teeth, and on teeth and bodies that bend.
class TwoContacts {
protected:
  static const AcceptedSteps& steps_on(const std::string& teeth) {
    std::unique_ptr<AcceptedSteps>& known = marches[teeth];
    if (!known) {
      const Settings moving = {{"start.place", "position"},
                               {"start.position", "4.5e-3"},
                               {"start.V0", "0.3"},
                               {"time.newton_tolerance", "1e-9"}};
      const Settings on_teeth =
          teeth == "rigid" ? Settings{{"start.H0", "-1.1"}} : with(bending(), {{"start.H0", "-1.8"}});
      known = std::make_unique<AcceptedSteps>(table3_case(with(with(after_leaving(), moving), on_teeth)), 0.25);
    }
    return *known;
  }
  // Their vectors must go before PETSc does.
  static void forget() { marches.clear(); }

private:
  static inline std::map<std::string, std::unique_ptr<AcceptedSteps>> marches;
};

constexpr const char* both_teeth[] = {"rigid", "bending"};

class LubricatedPairAt : public TwoContacts, public testing::TestWithParam<const char*> {
protected:
  static void TearDownTestSuite() { forget(); }

  /// C of a state as PETSc would have it at that time.
  OwnedVec transient(const AcceptedState& at) const { return system.vector(at.mass, at.motion); }

  /// C_0 of the second-order backward formula: rate = shift (C - C_0).
  OwnedVec history() const {
    OwnedVec history = transient(steps.last_but_one);
    petsc_check(VecAXPBY(history, -1.0 / 3.0, 4.0 / 3.0, transient(steps.before_last)));
    return history;
  }

  OwnedVec rate_at(Vec at) {
    OwnedVec rate = films.create_state();
    films.transient(at, rate);
    petsc_check(VecAXPY(rate, -1.0, C0));
    petsc_check(VecScale(rate, shift));
    return rate;
  }

  void linearise() {
    const OwnedVec rate = rate_at(state);
    system.pair->linearise(state, {rate, shift}, shift);
  }

  OwnedVec rows_at(Vec at) {
    OwnedVec rows = films.create_state();
    const OwnedVec rate = rate_at(at);
    films.residual(at, {rate, shift}, rows);
    return rows;
  }

  /// Rows differ by ten orders of magnitude from inlet to centre: each is divided by its own scale.
  double norm(Vec rows) const {
    OwnedVec scaled = films.create_state();
    petsc_check(VecCopy(rows, scaled));
    {
      const VecWriting values(scaled);
      for (std::size_t n = 0; n < row_scales.size(); ++n) values[n] /= row_scales[n];
    }
    PetscReal size = 0.0;
    petsc_check(VecNorm(scaled, NORM_2, &size));
    return size;
  }

  void keep_row_scales() {
    for (std::size_t k = 0; k < steps.last.numbers.size(); ++k) {
      const ContactFilm& film = system.film(k);
      const ReynoldsEquation& equation = film.discretisation()->equation();
      for (int i = 0; i < grid.nx(); ++i) {
        const StateLine line(film.state(), i);
        for (int j = 0; j < grid.y_count(); ++j) {
          row_scales.push_back(equation.row_scale(j, line.conductance(j), film.surfaces().entrainment[j], 0.0));
        }
      }
    }
  }

  /// A change of the state: of the pressures of some contacts, and of the motion. Small where the pressure is, so that
  /// no node changes between full and cavitated (there the rows have a kink).
  OwnedVec direction(const std::vector<double>& amplitudes, const Motion& motion) const {
    std::vector<std::vector<double>> changes;
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
      changes.emplace_back(grid.local_size(), 0.0);
      for (int i = 0; i < grid.nx(); ++i) {
        for (int j = 0; j < grid.y_count(); ++j) {
          const int n = i * grid.y_count() + j;
          const double wave = std::sin(2.3 * grid.x(i) + 0.4) * std::cos(0.6 * grid.y(j) + 0.5) +
                              0.3 * noise(i, grid.y_begin() + j, static_cast<unsigned>(k));
          changes[k][n] = amplitudes[k] * wave * steps.last.pressure[k][n];
        }
      }
    }
    return system.vector(changes, motion);
  }

  const AcceptedSteps& steps = steps_on(GetParam());
  const Grid& grid = steps.march.grid();
  PairAt system{steps.march, steps.last};
  FilmSystem& films = system.system();
  double shift = 1.5 / steps.last.dT;
  OwnedVec state = system.vector(steps.last.pressure, steps.last.motion);
  OwnedVec C0 = history();
  std::vector<double> row_scales;  ///< of the own nodes of all films
};

// The geometry of each time is in its own rho H: a history at the wrong place would leave a residual of 2e-2. The
// motion has the formula of third order, fitted to the swing of the state before.
TEST_P(LubricatedPairAt, an_accepted_step_fulfils_the_backward_formulas) {
  ASSERT_EQ(steps.last.numbers.size(), 2U);
  ASSERT_NEAR(steps.last.dT, steps.last_but_one.dT, 1e-12);
  const AcceptedState &last = steps.last, &before = steps.last_but_one;
  const PairAt pair_before(steps.march, before);
  const OwnedVec state_before = pair_before.vector(before.pressure, before.motion);
  const Swings swings = pair_before.pair->swings(before.T, pair_before.pair->film_quantities(state_before, before.T));
  const double w = swings.rates[0];
  const double dT = last.dT;
  const FrequencyFit fit =
      frequency_fit(w, slope_of_oscillation(w, {last.T, last.T - dT, last.T - 2.0 * dT, last.T - 3.0 * dT}));
  const Motion &long_before = steps.before_last.motion, &earliest = steps.earliest.motion;
  const auto rate = [&](const auto& now, const auto& then, const auto& long_ago, const auto& at_first) {
    return ((11.0 * now - 18.0 * then + 9.0 * long_ago - 2.0 * at_first) / (6.0 * dT)).eval();
  };
  // What a rate of second order is multiplied by, and what is added to it, to give one of third order.
  OwnRates rates{.factor = 11.0 / 9.0};
  const Eigen::VectorXd then = to_vector(before.motion), long_ago = to_vector(long_before);
  rates.constant =
      rate(0.0 * then, then, long_ago, to_vector(earliest)) - rates.factor * (-2.0 * then + 0.5 * long_ago) / dT;
  system.pair->step_motion(
      swings, [&](double) { return fit; }, rates);
  system.pair->place(last.T);
  const OwnedVec rows = rows_at(state);
  PetscReal size = 0.0;
  petsc_check(VecNorm(rows, NORM_2, &size));
  // Newton's tolerance, and the round-off of rates of differences.
  EXPECT_LT(size / films.weight(), 1.1 * steps.march.problem().numerics.steps.newton.tolerance + 1e-11);
  const auto rate_of = [&](Eigen::VectorXd Motion::*of) {
    return rate(last.motion.*of, before.motion.*of, long_before.*of, earliest.*of)[0];
  };
  EXPECT_NEAR(rate_of(&Motion::q) + fit.alpha * rate_of(&Motion::v), fit.beta * last.motion.V0(), 1e-6);
}

TEST_P(LubricatedPairAt, jacobian_passes_taylor_test) {
  const OwnedVec at_state = rows_at(state);
  keep_row_scales();
  const std::vector<OwnedVec> directions = [&] {
    std::vector<OwnedVec> list;
    list.push_back(direction({1.0, 0.0}, {}));
    list.push_back(direction({0.0, 1.0}, {}));
    list.push_back(direction({0.0, 0.0}, {1e-2, 0.3}));
    list.push_back(direction({1.0, -0.5}, {-1e-2, 0.1}));
    return list;
  }();
  for (std::size_t n = 0; n < directions.size(); ++n) {
    SCOPED_TRACE("direction " + std::to_string(n));
    const OwnedVec slope = films.create_state(), moved = films.create_state();
    linearise();
    films.multiply(directions[n], slope);
    EXPECT_GT(norm(slope), 1e-4);  // a slope of zero would pass as well
    double before = 0.0;
    for (const double step : {4e-3, 2e-3, 1e-3, 5e-4}) {
      petsc_check(VecWAXPY(moved, step, directions[n], state));
      const OwnedVec remainder = rows_at(moved);
      petsc_check(VecAXPY(remainder, -1.0, at_state));
      petsc_check(VecAXPY(remainder, -step, slope));
      const double size = norm(remainder);
      if (before > 0.0) expect_rate("jacobian_taylor_remainder", std::log2(before / size));
      before = size;
    }
  }
}

TEST_P(LubricatedPairAt, coasts_as_it_moves_but_no_deeper_than_half_a_film) {
  const double T = steps.last.T, dT = steps.last.dT;
  const std::vector<FilmQuantities> quantities = system.pair->film_quantities(state, T);
  const double film = std::min(quantities[0].central_film, quantities[1].central_film);
  for (const double by : {2.0 * film, -0.2 * film, -3.0 * film}) {
    const OwnedVec guess = system.vector(steps.last.pressure, {steps.last.motion.H0(), by / dT});
    system.pair->predict_without_force(guess, T, T + dT, quantities);
    const Motion coasted = system.pair->motion(guess);
    EXPECT_NEAR(coasted.H0() - steps.last.motion.H0(), std::max(by, -0.5 * film), 1e-12) << by / film;
    EXPECT_EQ(coasted.V0(), by / dT);
  }
}

// And through the bodies that the force on one tooth bends.
TEST_P(LubricatedPairAt, films_act_on_each_other_through_the_motion_and_bodies_only) {
  linearise();
  const OwnedVec rows = films.create_state(), change = direction({1.0, 0.0}, {});
  films.multiply(change, rows);
  const double bent = films.compliance()(1, 0) * integral(grid, films.field(change, 0));
  EXPECT_EQ(bent != 0.0, GetParam() == std::string("bending"));
  const std::span<const double> column = films.film(1).displacement_column();
  const std::vector<double> other = films.field(rows, 1);
  for (std::size_t n = 0; n < other.size(); ++n) EXPECT_NEAR(other[n], bent * column[n], 1e-12 * std::abs(column[n]));
  EXPECT_GT(largest(films.field(rows, 0)), 0.0);
  const Motion motion_rows = system.pair->motion(rows);
  EXPECT_EQ(motion_rows.H0(), 0.0);
  EXPECT_NE(motion_rows.V0(), 0.0);
}

// Of pressures (c - T)^2 and of rising ones at T = 0, 1, 2, extrapolated to T = 3 by a parabola.
TEST_P(LubricatedPairAt, guessed_pressures_that_fall_vanish_behind_an_edge_where_oil_flows_freely) {
  linearise();
  const std::vector<double> weights = {3.0, -3.0, 1.0};
  const std::vector<double> edges = {2.5, 4.5, 1.0};  // passed by T = 3, not passed, passed by T = 2
  std::vector<OwnedVec> states(3);
  const OwnedVec guess = films.create_state(), polynomial = films.create_state();
  for (std::size_t k = 0; k < states.size(); ++k) {
    std::vector<std::vector<double>> pressures = steps.last.pressure;
    for (std::vector<double>& film : pressures) {
      for (std::size_t n = 0; n < film.size(); ++n) {
        const double left =
            n % 4 < 3 ? std::max(0.0, edges[n % 4] - (2.0 - static_cast<double>(k))) : 3.0 - static_cast<double>(k);
        film[n] = left * left;
      }
    }
    states[k] = system.vector(pressures, steps.last.motion);
    petsc_check(VecAXPY(guess, weights[k], states[k]));
  }
  petsc_check(VecCopy(guess, polynomial));
  films.extrapolate_falls(guess, weights, [&](std::size_t n) -> Vec { return states[n]; });
  std::size_t free = 0, stiff = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<double> guessed = films.field(guess, k), plain = films.field(polynomial, k);
    for (std::size_t n = 0; n < guessed.size(); ++n) {
      if (!films.film(k).conducts_freely(n) || n % 4 == 3) {
        EXPECT_EQ(guessed[n], plain[n]);
        ++stiff;
      } else {
        EXPECT_NEAR(guessed[n], n % 4 == 1 ? 2.25 : 0.0, 1e-12);
        ++free;
      }
    }
  }
  EXPECT_GT(free, 0U);
  EXPECT_GT(stiff, 0U);
}

// Small ones may vanish.
TEST_P(LubricatedPairAt, guessed_pressures_fall_by_half_at_most_and_not_below_zero) {
  constexpr double small = 0.003;
  std::vector<std::vector<double>> guessed = steps.last.pressure;
  for (double& pressure : guessed[0]) pressure = -1.0;
  const OwnedVec guess = system.vector(guessed, {-1.0, -2.0});
  films.clip_predictor(guess, system.vector(steps.last.pressure, steps.last.motion));
  // Cavitated nodes of an accepted state may be negative by round-off.
  std::vector<std::vector<double>> expected = steps.last.pressure;
  for (double& pressure : expected[0]) pressure = pressure < small ? 0.0 : 0.5 * pressure;
  for (double& pressure : expected[1]) pressure = std::max(pressure, 0.0);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(films.field(guess, k), expected[k]);
  EXPECT_EQ(system.pair->motion(guess).H0(), -1.0);
  EXPECT_EQ(system.pair->motion(guess).V0(), -2.0);
}

TEST_P(LubricatedPairAt, a_multigrid_cycle_reduces_the_residual) {
  PairAt with_all_levels(steps.march, steps.last, 0);
  LubricatedPair& pair = *with_all_levels.pair;
  FilmSystem& all = pair.system();
  const OwnedVec rate = all.create_state(), rows = all.create_state(), change = all.create_state(),
                 left = all.create_state();
  all.residual(state, {rate, shift}, rows);
  pair.linearise(state, {rate, shift}, shift);
  all.precondition(rows, change);
  all.multiply(change, left);
  petsc_check(VecAYPX(left, -1.0, rows));
  PetscReal before = 0.0, after = 0.0;
  petsc_check(VecNorm(rows, NORM_2, &before));
  petsc_check(VecNorm(left, NORM_2, &after));
  EXPECT_LT(after, 0.5 * before);
  // dH_0/dT = V_0 holds exactly after it.
  EXPECT_NEAR(pair.motion(left).H0(), 0.0, 1e-10 * std::abs(pair.motion(rows).H0()));
}

INSTANTIATE_TEST_SUITE_P(teeth, LubricatedPairAt, testing::ValuesIn(both_teeth),
                         [](const auto& teeth) { return teeth.param; });

/// With how many levels, on which teeth.
class LubricatedPairPreconditioner : public TwoContacts, public testing::TestWithParam<std::tuple<int, const char*>> {
protected:
  static void TearDownTestSuite() { forget(); }
};

TEST_P(LubricatedPairPreconditioner, krylov_iterations_are_few) {
  const auto [levels, teeth] = GetParam();
  const AcceptedSteps& steps = steps_on(teeth);
  PairAt system(steps.march, steps.last, levels);
  FilmSystem& films = system.system();
  const double shift = 1.5 / steps.last.dT;
  const OwnedVec state = system.vector(steps.last.pressure, steps.last.motion);
  const OwnedVec rate = films.create_state(), rows = films.create_state(), change = films.create_state();
  films.residual(state, {rate, shift}, rows);
  system.pair->linearise(state, {rate, shift}, shift);
  // What a wrong first guess leaves: without any rate.
  NewtonOptions options;
  options.krylov_tolerance = 1e-3;
  OwnedSNES snes;
  petsc_check(SNESCreate(films.comm(), snes.put()));
  configure_newton(snes, films, options, films.weight());
  KSP ksp = nullptr;
  petsc_check(SNESGetKSP(snes, &ksp));
  const OwnedMat jacobian = shell_jacobian(films);
  petsc_check(KSPSetOperators(ksp, jacobian, jacobian));
  petsc_check(KSPSolve(ksp, rows, change));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  petsc_check(KSPGetConvergedReason(ksp, &reason));
  petsc_check(KSPGetIterationNumber(ksp, &iterations));
  report("%d level(s), %s teeth: %d iterations for a factor 1e-3", levels, teeth, static_cast<int>(iterations));
  EXPECT_GT(reason, 0);
  EXPECT_LE(iterations, 12);
}

INSTANTIATE_TEST_SUITE_P(levels, LubricatedPairPreconditioner,
                         testing::Combine(testing::Values(1, 0), testing::ValuesIn(both_teeth)));

}  // namespace
}  // namespace gearfilm

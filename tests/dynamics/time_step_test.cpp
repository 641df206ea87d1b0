// The time scheme between events: its order, and what it does when a step fails.
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// What one contact and the motion have come to.
struct EndOfMarch {
  double H0, V0, central_film;
};

EndOfMarch march_of(const Settings& settings, const std::string& dT, double T_end) {
  RecordedMarch march(table3_case(with(settings, {{"time.dt", dT}, {"time.newton_tolerance", "1e-10"}})));
  march.start();
  march.run(T_end);
  return {march.motion().H0(), march.motion().V0(), march.records().back().contacts.front().quantities["h_central"]};
}

// Levels with half the rows do not solve time steps of long cells while a contact enters, however short they are.
TEST(StepLevels, are_one_for_short_steps_of_long_cells) {
  const Grid slender(PETSC_COMM_WORLD, rectangle(529, 129, -2.166, 1.25, 59.8)),
      square(PETSC_COMM_WORLD, rectangle(257, 257, -2.5, 1.5, 1.5));
  EXPECT_EQ(step_levels(slender, 1.3 * slender.h_x()), 1);
  EXPECT_EQ(step_levels(slender, 2.5 * slender.h_x()), 0);
  EXPECT_EQ(step_levels(square, 1.3 * square.h_x()), 0);
}

/// A contact at the pitch point, linearised as in a time step.
struct LinearisedStep {
  explicit LinearisedStep(int levels) : film(shared, problem.scales, {.levels = levels}) {
    std::vector<double> pressure(grid.local_size());
    hertz_pressure(grid, problem.scales, problem.scales.hertz, pressure);
    state = pair.system().create_state();
    change = pair.system().create_state();
    pair.system().set_field(state, 0, pressure);
    pair.set_motion(state, {-1.4, 0.0});
    pair.place(0.0);
    pair.linearise(state, {}, 30.0);
  }

  std::vector<double> preconditioned() {
    pair.system().precondition(state, change);
    return pair.system().field(change, 0);
  }

  CaseInput problem = table3_case({{"grid.nx", "65"}, {"grid.ny", "33"}});
  MeshModel mesh = mesh_of(problem);
  SharedDiscretisation shared = discretise(Grid{PETSC_COMM_WORLD, case_grid(problem)}, problem);
  const Grid& grid = shared->grid();
  ContactFilm film;
  LubricatedPair pair{mesh, {{0, &film}}};
  OwnedVec state, change;
};

TEST(LongLinearSolve, has_levels_and_the_smoother_by_turns) {
  LinearisedStep levels(2), smoother(1);
  const auto by_levels = levels.preconditioned(), by_smoother = smoother.preconditioned();
  ASSERT_NE(by_levels, by_smoother);
  for (int n = 2; n <= 21; ++n) EXPECT_EQ(levels.preconditioned(), by_levels) << "application " << n;
  EXPECT_EQ(levels.preconditioned(), by_smoother);
  EXPECT_EQ(levels.preconditioned(), by_levels);
  EXPECT_EQ(levels.preconditioned(), by_smoother);
  levels.pair.linearise(levels.state, {}, 30.0);
  EXPECT_EQ(levels.preconditioned(), by_levels);
}

// Long enough that the oil at the centre has come in after the start. The half step of first order there does not spoil
// the second. From 0.03 on, 0.6 of the time in which oil passes a cell, films have formulas of third order.
class TimeStepOrder : public testing::TestWithParam<const char*> {};

TEST_P(TimeStepOrder, is_two_at_least) {
  constexpr double T_end = 1.5, least = 1.8;
  const bool bend = GetParam() == std::string("bending");
  const Settings settings =
      bend ? with(with(after_leaving(), bending()), {{"start.H0", "-2.4"}, {"start.V0", "0"}}) : after_leaving();
  const EndOfMarch coarse = march_of(settings, "0.05", T_end), fine = march_of(settings, "0.025", T_end),
                   limit = march_of(settings, "0.00625", T_end);
  const auto order_of = [&](const char* name, double EndOfMarch::*value) {
    const double far = std::abs(coarse.*value - limit.*value), near = std::abs(fine.*value - limit.*value);
    report("order of %s: %.2f, errors %.1e and %.1e", name, std::log2(far / near), far, near);
    return std::log2(far / near);
  };
  EXPECT_GT(order_of("H0", &EndOfMarch::H0), least);
  EXPECT_GT(order_of("V0", &EndOfMarch::V0), least);
  EXPECT_GT(order_of("central film", &EndOfMarch::central_film), least);
}

INSTANTIATE_TEST_SUITE_P(teeth, TimeStepOrder, testing::Values("rigid", "bending"),
                         [](const auto& teeth) { return teeth.param; });

/// H_0 two thirds of a mesh period after a contact has left, past an entry, and the steps that it took.
struct ControlledMarch {
  double H0 = 0.0;
  std::size_t steps = 0;
};

ControlledMarch controlled_march(const std::string& dT, std::optional<ErrorTolerance> tolerance) {
  CaseInput problem = table3_case(with(after_leaving(), {{"time.dt", dT}}));
  problem.numerics.steps.tolerance = tolerance;
  RecordedMarch march(problem);
  march.start();
  march.run(2.0 / 3.0 * march.path().mesh_period());
  return {march.motion().H0(), march.records().size()};
}

TEST(TimeSteps, a_tolerance_on_their_errors_chooses_their_lengths) {
  const ControlledMarch fine = controlled_march("0.00625", {}), equal = controlled_march("0.05", {});
  const auto error = [&](const ControlledMarch& march) { return std::abs(march.H0 - fine.H0); };
  const ControlledMarch loose = controlled_march("0.05", {{.motion = 1e-5}}),
                        tight = controlled_march("0.05", {{.motion = 1e-7}}),
                        films = controlled_march("0.05", {{.motion = 1e-5, .pressure = 1e-5}});
  for (const auto& [name, march] : {std::pair("equal", equal), {"1e-5", loose}, {"1e-7", tight}, {"films", films}}) {
    report("%s: %zu steps, H0 is off by %.1e", name, march.steps, error(march));
  }
  EXPECT_LT(loose.steps, equal.steps);
  EXPECT_LT(error(loose), 2e-3);
  EXPECT_LT(error(tight), 0.1 * error(loose));
  EXPECT_GT(films.steps, 2 * loose.steps);
  EXPECT_LT(error(films), 0.2 * error(equal));
}

/// Few Newton iterations to a small norm, so that many a step of 0.05 fails.
RecordedMarch march_with(int max_iterations, int max_rejections, bool by_short_steps = false) {
  CaseInput problem = table3_case(after_leaving());
  problem.numerics.steps.guess_by_short_steps = by_short_steps;
  problem.numerics.steps.newton.max_iterations = max_iterations;
  problem.numerics.steps.newton.tolerance = 1e-6;
  problem.numerics.steps.max_rejections = max_rejections;
  return RecordedMarch(problem);
}

TEST(TimeSteps, a_failed_step_is_repeated_shorter_and_the_nominal_step_comes_back) {
  constexpr double T_end = 1.0, nominal = 0.05;
  constexpr int max_iterations = 4;
  RecordedMarch march = march_with(max_iterations, StepOptions{}.max_rejections);
  march.start();
  march.run(T_end);
  int shorter = 0, back = 0;
  double T = 0.0, before = 0.0;
  for (const StepRecord& record : march.records()) {
    T += record.dT;
    EXPECT_NEAR(record.T, T, 1e-12);
    const bool last = record.T > T_end - nominal;  // a step shortened to land on the end
    if (record.dT == 0.0 || last) continue;
    const double halvings = std::log2(nominal / record.dT);
    EXPECT_NEAR(halvings, std::round(halvings), 1e-9) << "dT = " << record.dT;
    EXPECT_GE(halvings, -1e-9) << "dT = " << record.dT;
    const double from_start = record.T / nominal;
    const bool on_lattice = std::abs(from_start - std::round(from_start)) < 1e-9;
    if (halvings > 0.5) {
      // The iterations of the failed attempts are counted; another short step may go back to the nominal times.
      if (!on_lattice) {
        EXPECT_GT(record.newton, max_iterations) << "at T = " << record.T;
      }
      ++shorter;
    } else if (before > 0.0 && before < 0.9 * nominal) {
      ++back;
      EXPECT_TRUE(on_lattice) << "at T = " << record.T;
    }
    before = record.dT;
  }
  EXPECT_NEAR(T, T_end, 1e-12);
  EXPECT_GE(shorter, 1);
  EXPECT_GE(back, 1);
  RecordedMarch unlimited = march_with(StepOptions{}.newton.max_iterations, StepOptions{}.max_rejections);
  unlimited.start();
  unlimited.run(T_end);
  EXPECT_LT(unlimited.records().size(), march.records().size());
  // The error of steps of 0.05 is 2.4e-4 here.
  EXPECT_NEAR(march.motion().H0(), unlimited.motion().H0(), 5e-4);
}

TEST(TimeSteps, a_failed_step_is_tried_again_before_it_is_shortened) {
  constexpr double nominal = 0.05;
  constexpr int max_iterations = 5;
  RecordedMarch march = march_with(max_iterations, StepOptions{}.max_rejections);
  march.start();
  march.run(1.0);
  int again = 0;
  for (const StepRecord& record : march.records()) {
    if (record.dT > 0.99 * nominal && record.newton > max_iterations) ++again;
  }
  EXPECT_GE(again, 1);
}

TEST(TimeSteps, a_failed_step_is_made_whole_from_where_shorter_ones_lead) {
  const auto come_to = [](int max_iterations, bool by_short_steps) {
    RecordedMarch march = march_with(max_iterations, StepOptions{}.max_rejections, by_short_steps);
    march.start();
    march.run(2.0);
    return std::pair(march.march().halved_steps(), march.motion());
  };
  const auto [none, expected] = come_to(StepOptions{}.newton.max_iterations, true);
  const auto [halved, off] = come_to(4, false);
  const auto [fewer, near] = come_to(4, true);
  const auto error = [&](const Motion& motion) { return std::abs(motion.H0() - expected.H0()); };
  report("%d and %d halved steps, H0 is off by %.1e and %.1e", halved, fewer, error(off), error(near));
  EXPECT_EQ(none, 0);
  EXPECT_LT(fewer, halved);
  EXPECT_LT(error(near), error(off));
}

TEST(TimeSteps, a_step_that_fails_for_good_is_an_error_that_names_the_contact) {
  RecordedMarch march = march_with(1, 2);
  march.start();
  const std::string message = solve_error_of([&] { march.run(1.0); });
  for (const char* word : {"T = 0", "contact 0", "xi = -3.1", "0.05/2^2", "time_dt"}) {
    EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
  }
  EXPECT_EQ(march.records().size(), 1U);  // the start: no state that has not converged is shown
}

}  // namespace
}  // namespace gearfilm

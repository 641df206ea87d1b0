// Faults put into a march or a stationary film: each ends in an error that says where.
#include <gmock/gmock.h>

#include <limits>

#include "gearfilm/error.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The message of the SolveError that an action ends in; empty without one.
template <class Action>
std::string failure_of(Action&& action) {
  try {
    action();
  } catch (const SolveError& error) {
    return error.what();
  }
  return {};
}

// The node lies on one process, the message must reach all.
TEST(Faults, pressure_that_is_not_a_number_is_found_in_the_next_step) {
  RecordedMarch march(table3_case(after_leaving()));
  march.start();
  const Grid& grid = march.grid();
  PairState state = march.march().state();
  if (grid.rank() == grid.processes() - 1) {
    values_of(state.films.front(), field::pressure)[grid.nx() / 2 * grid.y_count()] = nan;
  }
  march.march().resume(0.0, state);
  const std::string message = failure_of([&] { march.run(1.0); });
  EXPECT_THAT(message, HasSubstr("contact 0"));
  EXPECT_THAT(message, HasSubstr("residual not a number at X = "));
}

TEST(Faults, error_in_an_observer_comes_out_of_the_time_steps_as_it_was) {
  RecordedMarch march(table3_case(after_leaving()));
  march.start();
  march.on_step = [](const StepRecord&, const std::vector<ActiveContact>&) {
    throw std::logic_error("in the observer");
  };
  EXPECT_THROW(march.run(1.0), std::logic_error);
}

TEST(Faults, stationary_film_without_iterations_enough_says_where_its_residual_is) {
  const CaseInput problem = table3_case(after_leaving());
  const Grid grid(PETSC_COMM_WORLD, case_grid(problem));
  ContactFilm film(discretise(grid, problem), problem.scales, problem.numerics.solver.multigrid);
  SolverOptions options = problem.numerics.solver;
  options.newton.max_iterations = 1;
  options.newton.tolerance = 1e-14;
  const std::string message =
      failure_of([&] { solve_stationary(film, LoadCondition::force(problem.scales.static_force), options); });
  EXPECT_THAT(message, HasSubstr("the largest residual "));
  EXPECT_THAT(message, HasSubstr(" at X = "));
}

}  // namespace
}  // namespace gearfilm

// After every step films show the state that the step has found, however it was found.
#include <algorithm>
#include <cmath>

#include "grid/integral.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// The quantities of a step come from its state; what a film shows must be the film of that state. Its
/// deformation was computed together with that of another film, which may differ in round-off.
void expect_shown_films(const CaseInput& problem, double mesh_periods, int least_halvings = 0) {
  RecordedMarch march(problem);
  ContactFilm fresh(march.discretisation(), problem.scales, {});
  std::vector<double> pressure(march.grid().local_size());
  int halvings = 0;
  march.on_step = [&](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
    halvings += record.halvings;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      SCOPED_TRACE("T = " + std::to_string(record.T) + ", contact " + std::to_string(contacts[k].number));
      const ContactFilm& film = *contacts[k].film;
      film.total_pressure().store(pressure);
      EXPECT_EQ(integral(march.grid(), pressure), record.contacts[k].quantities["force"]);
      move_surfaces(fresh, march.mesh().contact(contacts[k].number, record.T).conditions);
      fresh.evaluate(pressure, record.motion.H0());
      double difference = 0.0;
      for (int i = 0; i < march.grid().nx(); ++i) {
        for (int j = 0; j < march.grid().y_count(); ++j) {
          difference = std::max(difference, std::abs(film.thickness().row(i)[j] - fresh.thickness().row(i)[j]));
        }
      }
      EXPECT_LT(difference, 1e-13);
    }
  };
  march.start();
  march.run(mesh_periods * march.path().mesh_period());
  EXPECT_GE(halvings, least_halvings);
}

TEST(ShownFilm, is_that_of_the_step_through_entering_and_leaving) {
  expect_shown_films(table3_case(before_an_entry()), 1.0);
}

TEST(ShownFilm, is_that_of_the_step_with_controlled_steps) {
  expect_shown_films(table3_case(with(before_an_entry(), {{"time.tolerance", "1e-3"}})), 0.3);
}

// So few Newton iterations that steps fail: they are tried again, from where shorter ones lead too, and are halved.
TEST(ShownFilm, is_that_of_the_step_after_steps_that_failed) {
  CaseInput problem = table3_case(after_leaving());
  problem.numerics.steps.newton.max_iterations = 4;
  for (const bool by_short_steps : {false, true}) {
    problem.numerics.steps.guess_by_short_steps = by_short_steps;
    expect_shown_films(problem, 0.3, by_short_steps ? 0 : 1);
  }
}

}  // namespace
}  // namespace gearfilm

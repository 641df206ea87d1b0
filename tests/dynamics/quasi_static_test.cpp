// Bodies without inertia: at every moment in balance with the forces of all contacts.
#include <map>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

Settings without_inertia() {
  return {{"motion", "quasi_static"}, {"film.discretisation", "fitted"}, {"grid.nx", "65"}, {"grid.ny", "33"},
          {"time.dt", "0.05"},        {"start.place", "after_leaving"}};
}

double total_force(const StepRecord& record) {
  double sum = 0.0;
  for (const ContactRecord& contact : record.contacts) sum += contact.quantities["force"];
  return sum;
}

// In a hundredth of a mesh period the load passes to contacts that have come, or from those that have gone.
TEST(PairInBalance, load_passes_in_a_straight_line_to_the_contacts_that_are_there) {
  RecordedMarch march(table3_case(without_inertia()));
  march.start();
  const double period = march.path().mesh_period();
  march.run(1.2 * period);
  std::map<std::size_t, int> balanced, passing;  // steps by contacts
  double T_event = 0.0, left_over = 0.0;
  for (const StepRecord& record : march.records()) {
    const double excess = total_force(record) / march.static_force() - 1.0;
    const double event = march.path().last_event(record.T), passed = (record.T - event) / (0.01 * period);
    if (record.dT == 0.0) {
      T_event = event;
      left_over = excess;
    }
    const bool passes = passed < 1.0 && T_event == event;
    EXPECT_NEAR(excess, passes ? left_over * (1.0 - passed) : 0.0, 2e-5) << record.T;
    ++(passes ? passing : balanced)[record.contacts.size()];
  }
  for (const std::size_t contacts : {1U, 2U}) {
    EXPECT_GE(passing[contacts], 8) << contacts;
    EXPECT_GE(balanced[contacts], 8) << contacts;
  }
}

// Films forget within a mesh period, and bodies have nothing to remember.
TEST(PairInBalance, mesh_periods_repeat_at_once) {
  RecordedMarch march(table3_case(without_inertia()));
  const double period = march.path().mesh_period();
  march.start();
  march.run(2.0 * period);  // in the first one the grid is widened
  const double once = march.motion().H0();
  march.run(3.0 * period);
  EXPECT_NEAR(march.motion().H0(), once, 1e-4);
}

/// The thinnest film, up to 0.6 mesh periods, of the contact that enters apart from its mate [m].
double film_of_late_contact(const std::optional<std::string>& dt) {
  Settings settings = {{"motion", "quasi_static"},
                       {"film.discretisation", "fitted"},
                       {"pinion.torque", "5"},
                       {"pinion.speed_rpm", "300"},
                       {"pinion.tip_relief", "20e-6"},
                       {"wheel.tip_relief", "20e-6"},
                       {"grid.nx", "97"},
                       {"grid.ny", "33"}};
  if (dt) settings["time.dt"] = *dt;
  RecordedMarch march(input_case("barbieri2013_relief.yaml", settings));
  march.start();
  march.run(0.6 * march.path().mesh_period());
  double thinnest = HUGE_VAL;
  for (const StepRecord& record : march.records()) {
    for (const ContactRecord& contact : record.contacts) {
      if (contact.number == 1) thinnest = std::min(thinnest, contact.quantities["h_min"]);
    }
  }
  return thinnest;
}

// Steps far from where contacts enter and leave are long, but films that close are followed by short ones.
TEST(PairInBalance, a_contact_that_carries_late_is_followed_as_it_closes) {
  const double film = film_of_late_contact({});
  EXPECT_NEAR(film_of_late_contact("0.02") / film, 1.0, 0.02);
}

TEST(PairInBalance, steps_need_not_follow_a_swing_that_is_not_there) {
  const auto step_of = [](const std::string& motion) {
    return input_case("barbieri2013.yaml", {{"motion", motion}, {"pinion.speed_rpm", "500"}}).numerics.steps.dT;
  };
  EXPECT_GT(step_of("quasi_static"), 2.0 * step_of("dynamic"));
}

}  // namespace
}  // namespace gearfilm

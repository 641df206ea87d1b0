// Films that feel their heat, along a march.
#include <gtest/gtest.h>

#include "pair_case.hpp"
#include "traction/coupled_film.hpp"

namespace gearfilm {
namespace {

/// From the pitch point on, at rest there.
Settings heated_march(const char* dT) {
  Settings settings = with(after_leaving(), {{"friction.law", "eyring"},
                                             {"thermal.model", "film"},
                                             {"lubricant.temperature_viscosity", "0.04"},
                                             {"start.place", "position"},
                                             {"start.position", "0"},
                                             {"grid.nx", "65"},
                                             {"grid.ny", "33"},
                                             {"time.dt", dT}});
  settings.erase("start.H0");
  settings.erase("start.V0");
  return settings;
}

const ContactQuantities& last_quantities(const RecordedMarch& march) {
  return march.records().back().contacts.front().quantities;
}

// Conditions change little in the time that oil takes through the contact.
TEST(ThermalMarch, keeps_to_stationary_films_and_hardly_depends_on_the_step) {
  RecordedMarch march(table3_case(heated_march("0.05"))), finer(table3_case(heated_march("0.025")));
  for (RecordedMarch* each : {&march, &finer}) {
    each->start();
    each->run(0.28 * each->path().mesh_period());
  }
  const ContactQuantities &coarse = last_quantities(march), &fine = last_quantities(finer);
  EXPECT_NEAR(coarse["h_central"], fine["h_central"], 2e-3 * fine["h_central"]);
  EXPECT_NEAR(coarse["h_min"], fine["h_min"], 0.02 * fine["h_min"]);
  EXPECT_NEAR(coarse["friction_coefficient"], fine["friction_coefficient"], 2e-3 * fine["friction_coefficient"]);

  const ActiveContact& live = march.march().contacts().front();
  const MeshedContact contact = march.mesh().contact(live.number, march.march().T());
  ContactFilm film(march.discretisation(), march.mesh().scales, {});
  move_surfaces(film, contact.conditions);
  const LoadCondition load = LoadCondition::force(last_quantities(march)["force"]);
  const CoupledFilm still = solve_coupled(film, load, {}, *march.mesh().traction, solve_stationary(film, load, {}));
  EXPECT_NEAR(last_quantities(march)["h_central"], still.film.quantities.central_film,
              0.02 * still.film.quantities.central_film);
  EXPECT_NEAR(last_quantities(march)["friction_coefficient"], still.traction.quantities.coefficient,
              0.02 * still.traction.quantities.coefficient);
  EXPECT_LT(std::abs(last_quantities(march)["heat_balance"]), 1e-8);
}

TEST(ThermalMarch, goes_on_from_its_state_to_the_bit) {
  RecordedMarch whole(table3_case(heated_march("0.1"))), second(table3_case(heated_march("0.1")));
  whole.start();
  whole.run(0.1 * whole.path().mesh_period());
  const PairState state = whole.march().state();
  second.march().resume(whole.march().T(), state);
  for (RecordedMarch* march : {&whole, &second}) march->run(0.2 * march->path().mesh_period());
  EXPECT_EQ(whole.motion().H0(), second.motion().H0());
  for (const auto& [name, values] : whole.march().contacts().front().fields) {
    EXPECT_EQ(values, second.march().contacts().front().fields.at(name)) << name;
  }
}

// Whatever film object it gets.
TEST(ThermalMarch, a_contact_enters_with_its_own_heat) {
  Settings settings = heated_march("0.1");
  RecordedMarch march(table3_case(settings));
  march.start();
  march.run(1.3 * march.path().mesh_period());
  for (const StepRecord& record : march.records()) {
    for (const ContactRecord& contact : record.contacts) {
      EXPECT_GE(contact.quantities["film_temperature_max"], 363.1);
      EXPECT_LT(contact.quantities["film_temperature_max"], 900.0) << contact.number << " " << record.T;
    }
  }
}

}  // namespace
}  // namespace gearfilm

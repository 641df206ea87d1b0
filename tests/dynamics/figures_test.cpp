// The quantities of contacts: what their records compute, and that every list follows from them.
#include <set>

#include "dynamics/period_quantities.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// The quantities of one contact of Table 3's pair at xi under a force in units of F*.
ContactQuantities quantities_at(double xi, double force_ratio) {
  const CaseInput problem = table3_case();
  const MeshModel mesh = mesh_of(problem);
  FilmQuantities film;
  film.pressure_integral = force_ratio * problem.scales.static_force;
  return contact_record(mesh, 0, mesh.path.time_at(xi), film).quantities;
}

TEST(ContactQuantities, hertz_pressure_is_that_of_the_reference_under_its_load) {
  EXPECT_NEAR(quantities_at(0.0, 1.0)["p_hertz"], 1.0, 1e-12);
}

TEST(ContactQuantities, hertz_pressure_grows_with_the_cube_root_of_the_force) {
  const double once = quantities_at(2e-3, 1.0)["p_hertz"];
  EXPECT_NEAR(quantities_at(2e-3, 8.0)["p_hertz"], 2.0 * once, 1e-12);
  EXPECT_EQ(quantities_at(2e-3, 0.0)["p_hertz"], 0.0);
}

TEST(ContactQuantities, sliding_is_negative_before_the_pitch_point_and_positive_behind) {
  const CaseInput problem = table3_case();
  const double u = problem.scales.operation.entrainment_velocity;
  for (const double xi : {-3e-3, 2e-3}) {
    const double expected = problem.pair.line->sliding_velocity(xi, problem.pair.pinion_speed);
    EXPECT_GT(expected * xi, 0.0);
    EXPECT_NEAR(u * quantities_at(xi, 1.0)["sliding_velocity"], expected, 1e-12 * u);
  }
}

TEST(ContactQuantities, film_comes_back_out_of_the_quantities) {
  const FilmQuantities film{5.0, 0.3, 0.2, 1.1, 1.2, 1.15};
  const CaseInput problem = table3_case();
  const FilmQuantities again = film_quantities(contact_record(mesh_of(problem), 0, 0.0, film).quantities);
  EXPECT_EQ(again.pressure_integral, film.pressure_integral);
  EXPECT_EQ(again.central_film, film.central_film);
  EXPECT_EQ(again.smallest_film, film.smallest_film);
  EXPECT_EQ(again.central_pressure, film.central_pressure);
  EXPECT_EQ(again.largest_pressure, film.largest_pressure);
  EXPECT_EQ(again.spike_pressure, film.spike_pressure);
  EXPECT_TRUE(again.finite);
}

TEST(QuantityTables, every_name_is_there_once_with_value_unit_and_meaning) {
  std::set<std::string_view> columns, keys;
  const auto check = [&](const auto& table) {
    columns.clear();
    for (const auto& quantity : table) {
      EXPECT_TRUE(columns.insert(quantity.name).second) << quantity.name;
      EXPECT_TRUE(quantity.value && quantity.unit.in_si && !quantity.meaning.empty()) << quantity.name;
    }
  };
  check(contact_quantities);
  check(step_quantities);
  for (const PeriodQuantity& quantity : period_quantities) {
    EXPECT_TRUE(keys.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
  }
}

}  // namespace
}  // namespace gearfilm

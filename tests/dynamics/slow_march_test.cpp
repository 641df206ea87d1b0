// Marches of Table 3 against tests/reference/table3.json.
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// Compares with an entry, within the tolerance stated there.
void expect_reference(const nlohmann::json& entries, const std::string& name, double computed) {
  const auto& entry = entries.at(name);
  const double expected = entry.at("value");
  const double tolerance = entry.contains("abs_tol") ? entry.at("abs_tol").get<double>()
                                                     : entry.at("rel_tol").get<double>() * std::abs(expected);
  report("%-26s %14.6g  (%g +- %.2g)", name.c_str(), computed, expected, tolerance);
  EXPECT_NEAR(computed, expected, tolerance) << name;
}

void report_work(const RecordedMarch& march, double seconds) {
  int newton = 0, krylov = 0;
  for (const StepRecord& record : march.records()) {
    newton += record.newton;
    krylov += record.krylov;
  }
  report("dT = %g: %d records, %d Newton and %d Krylov iterations, %.1f s", march.problem().numerics.steps.dT,
         static_cast<int>(march.records().size()), newton, krylov, seconds);
}

TEST(SlowMarch, the_periodic_state_returns_after_one_mesh_period) {
  const auto& reference = table3::reference().at("film_periodic_129x65_dT_0.026");
  const double start = MPI_Wtime();
  RecordedMarch march(
      table3_case(with(after_leaving(), {{"grid.nx", "129"}, {"grid.ny", "65"}, {"time.dt", "0.026"}})));
  march.start();
  march.run(march.path().mesh_period());
  report_work(march, MPI_Wtime() - start);
  const MarchStatistics statistics = statistics_of(march);
  ASSERT_EQ(statistics.periods().size(), 1U);
  const PeriodQuantities& period = statistics.periods().front();
  const Scales& scales = march.problem().scales;
  expect_reference(reference, "H0_after_leaving", march.motion().H0());
  expect_reference(reference, "V0_after_leaving", march.motion().V0());
  expect_reference(reference, "force_ratio_max", period["force_ratio_max"].value() / scales.static_force);
  expect_reference(reference, "p_max", scales.pressure * period["p_max"].value());
  ASSERT_TRUE(period["pitch_h_central"] && period["entry_h_central"]);
  expect_reference(reference, "pitch_h_central", scales.thickness * period["pitch_h_central"].value());
  expect_reference(reference, "pitch_h_min", scales.thickness * period["pitch_h_min"].value());
  expect_reference(reference, "entry_h_central", scales.thickness * period["entry_h_central"].value());
  expect_reference(reference, "entry_h_min", scales.thickness * period["entry_h_min"].value());
  EXPECT_TRUE(statistics.losses().empty());
}

/// Motion at the first exit of a contact, from rest at the pitch point.
Motion at_first_exit(const nlohmann::json& reference, const std::string& dT) {
  const auto& domain = reference.at("domain");
  RecordedMarch march(table3_case({{"grid.nx", reference.at("nx").dump()},
                                   {"grid.ny", reference.at("ny").dump()},
                                   {"grid.x_min", domain.at(0).dump()},
                                   {"grid.x_max", domain.at(1).dump()},
                                   {"grid.y_half", domain.at(2).dump()},
                                   {"time.dt", dT}}));
  const double start = MPI_Wtime();
  march.start();
  march.run(march.path().exit_time(0));
  report_work(march, MPI_Wtime() - start);
  const auto events = statistics_of(march).events();
  EXPECT_EQ(events.size(), 2U);
  EXPECT_EQ(events.back().kind, MeshEvent::Kind::exit);
  EXPECT_EQ(events.back().contact, 0);
  return events.back().motion;
}

TEST(SlowMarch, from_rest_at_the_pitch_point_to_the_first_exit) {
  const auto& reference = table3::reference().at("start_from_pitch");
  const Motion motion = at_first_exit(reference, "0.026");
  expect_reference(reference, "H0_at_first_leaving", motion.H0());
  expect_reference(reference, "V0_at_first_leaving", motion.V0());
  const Motion halved = at_first_exit(reference, "0.013");
  report("half the step: H0 = %.5f", halved.H0());
  EXPECT_NEAR(halved.H0(), motion.H0(), 0.005 * std::abs(motion.H0()));
}

}  // namespace
}  // namespace gearfilm

// The pair on grids with all rows is the pair on grids with half of them.
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// Records of a march through the entering and the leaving of contacts, heat on its films or not.
std::vector<StepRecord> records_with(Edge lower, const Settings& settings, double mesh_periods) {
  const CaseInput problem = table3_case(settings);
  const PairNumerics& numerics = problem.numerics;
  const Grid grid(PETSC_COMM_WORLD,
                  grid_shape(numerics.domain, problem.scales.hertz.ellipticity, numerics.nx, numerics.ny, lower));
  std::vector<StepRecord> records;
  MeshMarch march =
      make_march(problem, discretise(grid, problem), mesh_of(problem),
                 [&](const StepRecord& record, const std::vector<ActiveContact>&) { records.push_back(record); });
  march.start(problem.march.start_motion);
  march.run(mesh_periods * march.mesh().path.mesh_period());
  return records;
}

void expect_same_march(const Settings& settings, double mesh_periods, std::size_t events, double tolerance) {
  const auto half = records_with(Edge::symmetry, settings, mesh_periods);
  const auto all = records_with(Edge::ambient, settings, mesh_periods);
  ASSERT_EQ(all.size(), half.size());
  std::size_t changes = 0;
  for (std::size_t n = 0; n < half.size(); ++n) {
    SCOPED_TRACE("T = " + std::to_string(half[n].T));
    ASSERT_DOUBLE_EQ(all[n].T, half[n].T);
    ASSERT_EQ(all[n].contacts.size(), half[n].contacts.size());
    if (n > 0 && half[n].contacts.size() != half[n - 1].contacts.size()) ++changes;
    EXPECT_NEAR(all[n].motion.H0(), half[n].motion.H0(), tolerance * std::abs(half[n].motion.H0()));
    EXPECT_NEAR(all[n].motion.V0(), half[n].motion.V0(), tolerance * std::abs(half[n].motion.V0()) + 1e-8);
    for (std::size_t k = 0; k < half[n].contacts.size(); ++k) {
      const ContactQuantities &computed = all[n].contacts[k].quantities, &expected = half[n].contacts[k].quantities;
      EXPECT_NEAR(computed["force"], expected["force"], tolerance * expected["force"]);
      EXPECT_NEAR(computed["h_central"], expected["h_central"], tolerance * expected["h_central"]);
      EXPECT_NEAR(computed["h_min"], expected["h_min"], tolerance * expected["h_min"]);
      EXPECT_NEAR(computed["p_max"], expected["p_max"], tolerance * expected["p_max"]);
    }
  }
  EXPECT_GE(changes, events);
}

// Newton's iterations stop at slightly different states.
TEST(WholeDomain, march_through_entering_and_leaving_is_that_on_half_the_rows) {
  expect_same_march(with(before_an_entry(), {{"time.newton_tolerance", "2e-6"}}), 1.0, 2, 2e-5);
}

TEST(WholeDomain, march_of_heated_films_is_that_on_half_the_rows) {
  expect_same_march(
      with(before_an_entry(),
           {{"friction.law", "eyring"}, {"thermal.model", "film"}, {"lubricant.temperature_viscosity", "0.04"}}),
      0.1, 1, 1e-4);
}

}  // namespace
}  // namespace gearfilm

// Passages of contacts over the flanks of a pair: at rest, and in a periodic motion against its frozen moments.
#include <gtest/gtest.h>

#include "damage_reference.hpp"
#include "film/contact_conditions.hpp"
#include "orbits/coarse_orbit.hpp"
#include "orbits/dry_orbit.hpp"
#include "pair_case.hpp"
#include "results/flank_result.hpp"
#include "results/static_passage.hpp"
#include "results/steady_result.hpp"

namespace gearfilm {
namespace {

Settings judged() { return {{"friction.law", "eyring"}, {"stress.model", "row"}, {"fatigue.criterion", "dang_van"}}; }

/// The force under a static section by the pressure on its middle, p ~ F^(1/3) [static forces].
double force_of(const MeshModel& rest, const SectionRecord& record) {
  const double force = rest.scales.static_force;
  const HertzContact whole = dry_contact(rest.scales, rest.contact_at(0, record.xi).conditions, force);
  return std::pow(-record.at(0, 0.0).zz / whole.pressure, 3);
}

TEST(StaticPassage, lies_below_dry_contacts_that_share_the_static_force) {
  const CaseInput problem = table3_case(with(judged(), {{"grid.nx", "65"}, {"grid.ny", "33"}, {"stress.points", "8"}}));
  const MeshModel rest = mesh_after_leaving(problem);
  const Grid grid(MPI_COMM_WORLD, case_grid(problem));
  const LineOfAction& line = rest.path.line();
  Passage passage{{FlankHistory(FlankPath(line, true)), FlankHistory(FlankPath(line, false))}};
  // Two contacts at a time near both ends, one between.
  const double both = line.entry() + 0.3 * (line.contact_ratio() - 1.0) * line.base_pitch(),
               alone = 0.5 * (line.entry() + line.exit());
  for (const double xi : {both, alone, both + line.base_pitch()}) {
    for (FlankHistory& history : passage.front()) history.add({.xi = xi, .values = {}});
  }
  const Passage at_rest = static_passage(grid, rest, passage);
  if (grid.rank() > 0) return;  // the surface is the first process's
  for (const FlankHistory& history : at_rest.front()) {
    const std::vector<SectionRecord>& records = history.records();
    ASSERT_EQ(records.size(), 3U);
    EXPECT_NEAR(force_of(rest, records[1]), 1.0, 0.01);
    const double first = force_of(rest, records[0]), second = force_of(rest, records[2]);
    EXPECT_NEAR(first + second, 1.0, 0.01);
    EXPECT_GT(std::min(first, second), 0.2);
  }
}

/// A section as the history of a point that it passes over unchanged.
std::vector<Stress> as_history(const SectionRecord& record, int depth) {
  std::vector<Stress> stresses{{}};
  for (int line = 0; line < record.places.count; ++line) {
    stresses.push_back(record.at(depth, record.places.first + line * record.places.step));
  }
  stresses.emplace_back();
  return stresses;
}

TEST(FrozenSection, of_a_film_at_rest_has_the_number_of_the_reference) {
  const CaseInput problem = table3_case(with(judged(), {{"steady.position", "4e-3"},
                                                        {"pinion.speed_rpm", "6000"},
                                                        {"grid.nx", "129"},
                                                        {"grid.ny", "33"},
                                                        {"film.discretisation", "central"}}));
  const SteadyPosition position = steady_position(problem);
  const Grid grid(MPI_COMM_SELF, steady_grid(MPI_COMM_SELF, problem, position, [](MPI_Comm, const GridShape&) {}));
  const SteadyResult result = solve_steady(grid, problem, position, [](const std::string&) {});
  StressModel below = *problem.stress;
  below.depths = {0.0, 0.6};
  const FilmSections sections =
      film_sections(below, *result.solved.film, result.friction.fields.shear_stress, {result.stress_row});
  const SectionRecord record =
      section_records(problem.scales, *sections.rows, *sections.stresses, problem.steady.position)[0][pinion_body];
  EXPECT_NEAR(dang_van(as_history(record, 1), {.alpha = 0.3}) / 1e6 / damage_number("ehl_steady_dv_alpha.3_z.6a_MPa"),
              1.0, 0.01);
}

/// The largest Dang Van stress if the section of each moment were the history of the point in its middle, from a depth
/// on and off the ends of the flank.
double frozen(const MeshModel& mesh, const FlankHistory& history) {
  const FatigueModel& fatigue = *mesh.fatigue;
  const FlankPath& path = history.path();
  const double margin = fatigue.margin * mesh.scales.length;
  double largest = 0.0;
  for (const SectionRecord& record : history.records()) {
    const double s = path.arc_length(record.xi);
    if (s < path.lowest() + margin || s > path.highest() - margin) continue;
    for (int depth = 0; depth < record.depths; ++depth) {
      if (mesh.stress->depths[depth] < fatigue.from_depth) continue;
      largest = std::max(largest, dang_van(as_history(record, depth), fatigue.dang_van));
    }
  }
  return largest;
}

// 129 x 33 nodes, as the reference.
TEST(SlowPassages, are_less_severe_than_frozen_moments) {
  const CaseInput problem = table3_case(with(judged(), {{"grid.ny", "33"}}));
  OrbitProblem search = orbit_problem(problem);
  search.search.with_multipliers = false;
  const SharedDiscretisation films = discretise(MPI_COMM_WORLD, search);
  const DryOrbit dry = find_dry_orbit(search.mesh, search.search.dry_damping_ratio);
  const FoundOrbit found = find_orbit(search, films, dry, {});
  const std::vector<Passage> passages = orbit_passages(search, films, found.own.orbit, [](double) {});
  ASSERT_EQ(passages.size(), 1U);
  Summary summary;
  add_flanks(search.mesh, flank_results(Grid(MPI_COMM_WORLD, found.own.orbit.end.shape), search.mesh, passages),
             summary);
  const double passing = summary["dang_van_max_pinion"].get<double>();
  EXPECT_NEAR(passing / 1e6 / damage_number("per1_dv_alpha.3_pinion_max_MPa"), 1.0, 0.03);
  EXPECT_NEAR(frozen(search.mesh, passages[0][0][pinion_body]) / passing / damage_number("per1_frozen_over_passing"),
              1.0, 0.03);
}

}  // namespace
}  // namespace gearfilm

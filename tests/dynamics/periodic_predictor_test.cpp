// Guesses that know what those of the mesh period before missed: fewer iterations to the same states.
#include "dynamics/periodic_predictor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "dynamics/entering_film.hpp"
#include "dynamics/miss_code.hpp"
#include "dynamics/packed_integers.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

TEST(Guesses, that_remember_a_mesh_period_save_iterations_and_change_nothing) {
  const CaseInput problem = table3_case(after_leaving());
  const double mesh_period = mesh_of(problem).path.mesh_period();
  Memory first;
  int newton = 0;
  const auto march_with = [&](Memory& memory) {
    auto march = std::make_unique<MeshMarch>(make_march(
        problem, discretise(PETSC_COMM_WORLD, problem), mesh_of(problem),
        [&](const StepRecord& record, const std::vector<ActiveContact>&) { newton += static_cast<int>(record.newton); },
        &memory));
    march->start(problem.march.start_motion);
    march->run(2.0 * mesh_period);
    return march->state();
  };
  march_with(first);
  StoredRun after_one =
      *std::ranges::find_if(first.kept, [&](const StoredRun& kept) { return kept.T > 0.99 * mesh_period; });
  ASSERT_NEAR(after_one.T, mesh_period, 1e-6);

  std::vector<int> iterations;
  std::vector<PairState> ends;
  for (const bool remembers : {true, false}) {
    Memory again;
    again.known = after_one;
    if (!remembers) again.known->memory.clear();
    newton = 0;
    ends.push_back(march_with(again));
    iterations.push_back(newton);
  }
  const double motion = std::max(std::abs(ends[0].motion.H0() - ends[1].motion.H0()),
                                 std::abs(ends[0].motion.V0() - ends[1].motion.V0()));
  double films = 0.0;
  for (std::size_t k = 0; k < ends[0].films.size(); ++k)
    films = std::max(films, relative_difference(values_of(ends[0].films[k], field::pressure),
                                                values_of(ends[1].films[k], field::pressure)));
  report("%d Newton iterations in the place of %d; the motion differs by %.1e, pressures by %.1e", iterations[0],
         iterations[1], motion, films);
  EXPECT_LT(iterations[0], 0.9 * iterations[1]);
  EXPECT_LT(motion, 1e-5);
  EXPECT_LT(films, 1e-4);
}

TEST(Guesses, the_film_that_entered_last_is_one_for_another_that_lies_near) {
  const CaseInput problem = table3_case(after_leaving());
  const MeshModel mesh = mesh_of(problem);
  ContactFilm film(discretise(PETSC_COMM_WORLD, problem), problem.scales, MultigridOptions{});
  move_surfaces(film, mesh.contact(0, 0.0).conditions);
  const double H0 = problem.march.start_motion->H0();
  const auto at = [](double displacement) { return LoadCondition::displacement(displacement); };
  EnteringFilm entering;
  const auto enters = [&](double displacement) {
    return entering.solve(film, at(displacement), problem.numerics.solver);
  };
  EXPECT_GT(enters(H0).by_grid.size(), 1U);
  for (const double displacement : {H0 + 0.01, H0 + 0.5}) {
    const bool near = displacement < H0 + 0.1;
    const StationaryResult entered = enters(displacement);
    const StationaryResult expected = solve_stationary(film, at(displacement), problem.numerics.solver);
    EXPECT_EQ(entered.by_grid.size(), near ? 1U : expected.by_grid.size());
    EXPECT_LT(relative_difference(entered.solution.pressure, expected.solution.pressure), near ? 1e-5 : 1e-12);
  }
}

TEST(Guesses, are_what_they_were_after_being_kept) {
  const CaseInput problem = table3_case(before_an_entry());
  Memory memory;
  MeshMarch march = make_march(
      problem, discretise(PETSC_COMM_WORLD, problem), mesh_of(problem),
      [](const StepRecord&, const std::vector<ActiveContact>&) {}, &memory);
  march.start(problem.march.start_motion);
  march.run(0.5);
  ASSERT_FALSE(memory.kept.empty());
  const std::vector<double>& values = memory.kept.back().memory;
  EXPECT_GT(values.size(), 100U);
  MeshMarch other = make_march(problem, discretise(PETSC_COMM_WORLD, problem), mesh_of(problem),
                               [](const StepRecord&, const std::vector<ActiveContact>&) {});
  const std::vector<double> nothing = other.memory();
  other.remember(values);
  const std::vector<double> again = other.memory();
  ASSERT_EQ(again.size(), values.size());
  EXPECT_EQ(std::memcmp(again.data(), values.data(), values.size() * sizeof(double)), 0);
  other.remember({});
  EXPECT_EQ(other.memory(), nothing);
}

TEST(MissCode, keeps_small_parts_as_exactly_as_large_ones_but_on_grids_of_many_nodes) {
  const MissCode few(1000.0), many(MissCode::many_nodes);
  for (const double part : {1.0, -0.37, 0.01, -1e-4, 1e-6, 1e-8}) {
    EXPECT_NEAR(few.decoded(few.encoded(part)) / part, 1.0, 2.5e-4 / std::pow(std::abs(part), 0.25)) << part;
    EXPECT_NEAR(many.decoded(many.encoded(part)), part, 1.6e-5) << part;
  }
  for (const MissCode& code : {few, many}) {
    EXPECT_EQ(code.decoded(code.encoded(0.0)), 0.0);
    EXPECT_EQ(code.decoded(code.encoded(1.0)), 1.0);
    EXPECT_EQ(code.decoded(code.encoded(-1.0)), -1.0);
  }
}

TEST(PackedIntegers, are_the_same_again_and_take_a_byte_where_they_change_little) {
  std::vector<std::int16_t> integers = {0, 1, -1, 63, -64, 64, 8191, -8192, 32767, -32768, 32767, 0, 0, 7};
  for (const std::size_t equal : {1U, 255U, 256U, 257U, 1000U}) {
    integers.insert(integers.end(), equal, static_cast<std::int16_t>(equal));
  }
  EXPECT_EQ(unpacked(packed(integers), integers.size()), integers);
  EXPECT_EQ(unpacked(packed({}), 0), std::vector<std::int16_t>());
  std::vector<std::int16_t> field(1000, 0);
  for (int n = 0; n < 200; ++n) field[400 + n] = static_cast<std::int16_t>(1000.0 * std::sin(n * M_PI / 200.0));
  EXPECT_LT(packed(field).size(), 220U);
  EXPECT_EQ(unpacked(packed(field), field.size()), field);
}

}  // namespace
}  // namespace gearfilm

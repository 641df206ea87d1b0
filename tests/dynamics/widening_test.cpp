// Grids that are widened on the way of a march: the films are those of a wide grid, and nothing is lost between the
// two.
#include <algorithm>

#include "grid/remap.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// A mesh period at 8000 rpm, where the force reaches twice the static one.
class Widening : public testing::Test {
protected:
  static Settings settings(const std::string& y_half, const std::string& ny) {
    return {
        {"grid.nx", "65"}, {"grid.ny", ny}, {"time.dt", "0.05"}, {"grid.y_half", y_half}, {"pinion.speed_rpm", "8000"}};
  }
  std::unique_ptr<MeshMarch> march_with(const CaseInput& problem, RunStore* store = nullptr) {
    auto march = std::make_unique<MeshMarch>(make_march(
        problem, discretise(PETSC_COMM_WORLD, problem), mesh_of(problem),
        [this](const StepRecord& record, const std::vector<ActiveContact>&) { records.push_back(record); }, store));
    march->start(problem.march.start_motion);
    return march;
  }

  std::vector<StepRecord> records;
  static CaseInput with_clear_sides(CaseInput problem) {
    problem.numerics.margins.side = 1.4;
    return problem;
  }
  const CaseInput narrow = with_clear_sides(table3_case(settings("1.65", "45")));
  const double T_end = mesh_of(narrow).path.mesh_period();
};

TEST_F(Widening, gives_the_forces_of_a_grid_that_was_wide_from_the_start) {
  // The same steps: 22 cells to the narrow side, 28 to the wide one.
  const CaseInput wide = with_clear_sides(table3_case(settings("2.1", "57")));
  const auto marches = [&](const CaseInput& problem) {
    records.clear();
    const auto march = march_with(problem);
    march->run(T_end);
    return std::pair(march->discretisation()->grid().shape(), records);
  };
  const auto [widened_shape, widened_records] = marches(narrow);
  const auto [wide_shape, wide_records] = marches(wide);
  EXPECT_GT(widened_shape.ny(), 45);
  EXPECT_EQ(wide_shape.ny(), 57);
  double largest = 0.0;
  for (const StepRecord& record : widened_records) {
    const auto same_time = [&](const StepRecord& other) {
      return std::abs(other.T - record.T) < 1e-9 && other.dT > 0.0;
    };
    const auto other = std::ranges::find_if(wide_records, same_time);
    if (record.dT == 0.0 || other == wide_records.end()) continue;
    largest = std::max(largest, std::abs(record.pressure_integral() - other->pressure_integral()));
  }
  report("widened to %d rows; forces differ by %.1e of the static force", widened_shape.ny(),
         largest / narrow.scales.static_force);
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(largest, 3e-4 * narrow.scales.static_force);
}

TEST_F(Widening, carries_films_over_without_a_change_of_mass) {
  Memory memory;
  const auto march = march_with(narrow, &memory);
  march->run(T_end);
  const GridShape last = march->discretisation()->grid().shape();
  ASSERT_FALSE(memory.kept.empty());
  const PairState& before = memory.kept.front().state;
  ASSERT_NE(before.shape, last);
  const PairState after = remapped(before, PETSC_COMM_WORLD, last);
  const auto mass_of = [&](const PairState& state) {
    const Grid grid(PETSC_COMM_WORLD, state.shape);
    ContactFilm film(discretise(grid, narrow), narrow.scales, MultigridOptions{});
    const auto& pressure = values_of(state.films.front(), field::pressure);
    std::vector<double> mass(pressure.size());
    film.mass(pressure, state.motion.H0(), mass);
    return remapped(mass, grid, Grid(PETSC_COMM_WORLD, before.shape));
  };
  EXPECT_LT(relative_difference(mass_of(after), mass_of(before)), 1e-13);
}

// From every state that was kept: before, at and after the widening.
TEST_F(Widening, is_gone_through_again_to_the_bit) {
  Memory memory;
  const auto march = march_with(narrow, &memory);
  march->run(T_end);
  const PairState whole = march->state();
  ASSERT_GT(memory.kept.size(), 1U);
  for (const StoredRun& kept : memory.kept) {
    Memory again;
    again.known = kept;
    const auto resumed = march_with(narrow, &again);
    resumed->run(T_end);
    const PairState end = resumed->state();
    EXPECT_EQ(end.motion.H0(), whole.motion.H0()) << "from T = " << kept.T;
    EXPECT_EQ(end.motion.V0(), whole.motion.V0());
    EXPECT_EQ(end.shape, whole.shape);
    EXPECT_EQ(end.films, whole.films);
  }
}

TEST_F(Widening, is_told_of_before) {
  int told = 0;
  const SharedDiscretisation films = discretise(PETSC_COMM_WORLD, narrow);
  MarchOptions options{narrow.numerics.solver, narrow.numerics.steps, narrow.numerics.margins};
  options.films.multigrid.levels = 1;
  GridShape shape = films->grid().shape();
  options.on_widening = [&](MPI_Comm, const GridShape& next) {
    ++told;
    EXPECT_GE(next.nx, shape.nx);
    EXPECT_GE(next.ny(), shape.ny());
    EXPECT_NE(next, shape);
    shape = next;
  };
  MeshMarch march(films, mesh_of(narrow), options, [](const StepRecord&, const std::vector<ActiveContact>&) {});
  march.start(narrow.march.start_motion);
  march.run(T_end);
  EXPECT_GT(told, 0);
  EXPECT_EQ(march.discretisation()->grid().shape(), shape);
}

TEST(Refined, state_is_the_same_at_the_nodes_it_had_and_smooth_between) {
  const GridShape coarse = rectangle(17, 13, -2.0, 1.2, 1.5);
  const auto bump = [](double x, double y) { return 1.0 + 0.3 * x - 0.2 * y * y + 0.1 * x * x * y * y; };
  const auto on = [&](const Grid& grid) {
    Field<double> field(grid);
    fill(grid, field, bump);
    std::vector<double> compact(grid.local_size());
    field.store(compact);
    return compact;
  };
  PairState state{{-1.0, 0.2}, {{}}, coarse};
  state.films[0].emplace(field::pressure.name, on(Grid(PETSC_COMM_WORLD, coarse)));
  const PairState fine = refined(state, PETSC_COMM_WORLD, Coarsening::both);
  EXPECT_EQ(fine.shape, (rectangle(33, 25, -2.0, 1.2, 1.5)));
  EXPECT_EQ(fine.motion.H0(), -1.0);
  // Rows over a face stay, equal ones too.
  const PairState lines = refined(state, PETSC_COMM_WORLD, Coarsening::x_only);
  EXPECT_EQ(lines.shape.row_axis, state.shape.row_axis);
  EXPECT_EQ(values_of(lines.films[0], field::pressure).size(), Grid(PETSC_COMM_WORLD, lines.shape).local_size());
  const Grid grid(PETSC_COMM_WORLD, fine.shape);
  const std::vector<double>& values = values_of(fine.films[0], field::pressure);
  for (int i = 2; i < grid.nx() - 2; ++i) {
    for (int j = 0; j < grid.y_count() && grid.y_begin() + j < grid.rows() - 2; ++j) {
      EXPECT_NEAR(values[i * grid.y_count() + j], bump(grid.x(i), grid.y(j)), 1e-12) << i << " " << j;
    }
  }
}

TEST(Refined, films_become_those_of_the_grid) {
  constexpr double T = 1.0, soon = 1.25;
  const Settings wide = {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}, {"start.place", "after_leaving"}};
  RecordedMarch coarse(table3_case(with(with(after_leaving(), {{"time.dt", "0.025"}}), wide)));
  coarse.start();
  coarse.run(T);
  const PairState state = refined(coarse.march().state(), PETSC_COMM_WORLD, Coarsening::both);
  coarse.run(soon);
  const auto newton_iterations = [&](bool adapted) {
    RecordedMarch fine(
        table3_case(with(with(after_leaving(), {{"time.dt", "0.025"}, {"grid.nx", "129"}, {"grid.ny", "65"}}), wide)));
    fine.march().resume(T, state);
    if (adapted) fine.march().adapt_pressures();
    fine.run(soon);
    const auto quantities = [](const RecordedMarch& march) {
      return march.records().back().contacts.front().quantities;
    };
    // What the grids differ by at the same H_0.
    EXPECT_NEAR(quantities(fine)["h_central"] / quantities(coarse)["h_central"], 1.0, 0.12);
    EXPECT_NEAR(quantities(fine)["force"] / quantities(coarse)["force"], 1.0, 0.02);
    int sum = 0;
    for (const StepRecord& record : fine.records()) sum += record.newton;
    return sum;
  };
  const int adapted = newton_iterations(true), as_they_are = newton_iterations(false);
  report("Newton iterations of the steps after it: %d, from interpolated films: %d", adapted, as_they_are);
  EXPECT_LT(adapted, as_they_are);
}

}  // namespace
}  // namespace gearfilm

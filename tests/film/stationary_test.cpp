// The stationary film: the numbers of two independent programs, conservation, symmetry, order, parallel agreement.
#include <algorithm>
#include <numbers>
#include <tuple>

#include "film_case.hpp"

namespace gearfilm {
namespace {

using table3::reference;

/// Equivalent point contact (27) of the Table 2 pair at its pitch point, on the long domain.
FilmCase table2_equivalent() {
  const SpurGearPair pair{.pinion = {.teeth = 35, .outer_radius = 36.50e-3, .crowning = 0.020e-3},
                          .wheel = {.teeth = 140, .outer_radius = 141.04e-3, .crowning = 0.020e-3},
                          .module_length = 2e-3,
                          .pressure_angle = 20.0 * std::numbers::pi / 180.0,
                          .centre_distance = 174.5e-3,
                          .face_width = 20e-3};
  constexpr double torque = 95.49, pinion_speed = 1200.0 * 2.0 * std::numbers::pi / 60.0;
  const LineOfAction line(pair);
  const ContactSolids solids{.radius_x = line.radius_x(0.0),
                             .radius_y = line.radius_y(),
                             .reduced_modulus = reduced_modulus(226e9, 0.3, 226e9, 0.3)};
  const double load_per_length = torque / line.base_radius_pinion() / pair.face_width;
  const double half_width = hertz_line_half_width(load_per_length, solids.radius_x, solids.reduced_modulus);
  // eta_0 is inferred: Table 2 names no lubricant (tests/reference/table3.json).
  return {make_scales(solids, {.viscosity = 0.075, .pressure_viscosity = 2.2e-8},
                      {.load = equivalent_point_load(solids, half_width),
                       .entrainment_velocity = line.entrainment_velocity(0.0, pinion_speed)}),
          {.x_min = -4.5, .x_max = 1.5, .y_half = 3.0}};
}

/// What holds for any stationary film.
void expect_sound(const SolvedFilm& solved) {
  const double force = solved.film.scales().static_force;
  EXPECT_NEAR(solved.result.quantities.pressure_integral, force, 1e-6 * force);
}

/// Solves on the grid of a row of tests/reference/table3.json and compares what the row holds.
void expect_row(const FilmCase& film_case, const nlohmann::json& row) {
  SolverOptions options;
  options.newton.tolerance = 1e-10;  // what symmetry and balance are then good to is far below what is asked
  const SolvedFilm solved(PETSC_COMM_WORLD, film_case, row.at("nx"), row.at("ny"), options, Edge::symmetry,
                          FilmDiscretisation::central);
  const FilmQuantities& quantities = solved.result.quantities;
  const double metres = film_case.scales.thickness;
  const std::pair<const char*, double> values[] = {
      {"H_central", quantities.central_film},
      {"H_min", quantities.smallest_film},
      {"H0", solved.result.solution.H0},
      {"h_central", metres * quantities.central_film},
      {"h_min", metres * quantities.smallest_film},
  };
  for (const auto& [name, computed] : values) {
    if (!row.contains(name)) continue;
    const double expected = row.at(name), tolerance = row.at("rel_tol");
    EXPECT_NEAR(computed, expected, tolerance * std::abs(expected)) << name << " on " << row.dump();
    report("%4d x %-4d %-10s %.6g, reference %.6g", solved.grid.nx(), solved.grid.ny(), name, computed, expected);
  }
  expect_sound(solved);
}

TEST(Stationary, reproduces_the_pitch_film_of_table3) { expect_row(table3_pitch(), reference().at("steady_pitch")[0]); }

TEST(Stationary, reproduces_the_circular_contact) {
  expect_row(circular_contact(), reference().at("steady_circular_M20_L10")[0]);
}

TEST(SlowStationary, reproduces_the_pitch_film_of_table3_on_finer_grids) {
  for (int row : {1, 2}) expect_row(table3_pitch(), reference().at("steady_pitch")[row]);
}

TEST(SlowStationary, reproduces_the_circular_contact_on_a_fine_grid) {
  expect_row(circular_contact(), reference().at("steady_circular_M20_L10")[1]);
}

TEST(SlowStationary, reproduces_the_pitch_film_of_table2) {
  for (const auto& row : reference().at("table2_pitch")) expect_row(table2_equivalent(), row);
}

// The limit of Table 3's pitch film on these rows, 2.475 um, and of a slender contact, from twelve times the nodes.
TEST(Stationary, fitted_films_are_near_their_limits_on_few_nodes) {
  const FilmCase pitch = table3_pitch();
  for (const int nx : {33, 65}) {
    const SolvedFilm solved(PETSC_COMM_WORLD, pitch, nx, 65);
    EXPECT_NEAR(pitch.scales.thickness * solved.result.quantities.central_film, 2.475e-6, 5e-3 * 2.475e-6) << nx;
  }
  const FilmCase slender = moes_contact(1e5, 6.0, 0.001);
  const SolvedFilm fine(PETSC_COMM_WORLD, slender, 513, 97);
  const auto errors = [&](FilmDiscretisation by) {
    const SolvedFilm coarse(PETSC_COMM_WORLD, slender, 129, 33, {}, Edge::symmetry, by);
    const FilmQuantities &found = coarse.result.quantities, &limit = fine.result.quantities;
    const std::array<double, 2> of = {found.central_film / limit.central_film - 1.0,
                                      found.smallest_film / limit.smallest_film - 1.0};
    report("%s: %.2f %% central, %.2f %% smallest", by == FilmDiscretisation::fitted ? "fitted" : "central",
           100.0 * of[0], 100.0 * of[1]);
    return of;
  };
  const auto fitted = errors(FilmDiscretisation::fitted), central = errors(FilmDiscretisation::central);
  EXPECT_LT(std::abs(fitted[0]), 0.01);
  EXPECT_LT(std::abs(fitted[1]), 0.025);
  EXPECT_LT(central[0], -0.1);
}

/// Order seen in the central films of three grids, each twice as fine as the one before.
void expect_second_order(const FilmCase& film_case, const std::string& name) {
  std::vector<double> films;
  for (const auto& [nx, ny] : {std::pair{65, 33}, {129, 65}, {257, 129}}) {
    films.push_back(SolvedFilm(PETSC_COMM_WORLD, film_case, nx, ny).result.quantities.central_film);
  }
  const double observed = std::log2((films[1] - films[0]) / (films[2] - films[1]));
  report("%s: H_central %.6f %.6f %.6f, order %.3f", name.c_str(), films[0], films[1], films[2], observed);
  expect_rate(name, observed);
}

TEST(Stationary, film_converges_second_order_in_the_circular_contact) {
  expect_second_order(circular_contact(), "film_circular_M20_L10");
}

TEST(Stationary, film_converges_second_order_in_the_pitch_contact) {
  expect_second_order(table3_pitch(), "film_table3_pitch");
}

TEST(Stationary, same_answer_on_any_number_of_processes) {
  for (const auto& [film_case, nx, ny] : {std::tuple{table3_pitch(), 129, 65}, {circular_contact(), 65, 65}}) {
    const SolvedFilm distributed(PETSC_COMM_WORLD, film_case, nx, ny);
    const SolvedFilm alone(PETSC_COMM_SELF, film_case, nx, ny);
    const auto film = whole_of(alone.grid, alone.film.thickness());
    double difference = 0.0;
    const auto other = whole_of(distributed.grid, distributed.film.thickness());
    for (std::size_t n = 0; n < film.size(); ++n) difference = std::max(difference, std::abs(other[n] / film[n] - 1.0));
    // Two solutions to a residual of 1e-8.
    EXPECT_LT(difference, 1e-6);
    const auto pressure = whole_of(alone.grid, alone.film.total_pressure());
    const double off = relative_difference(whole_of(distributed.grid, distributed.film.total_pressure()), pressure);
    EXPECT_LT(off, 1e-6);
    EXPECT_NEAR(distributed.result.solution.H0, alone.result.solution.H0, 1e-6);
    report("%d x %d: films differ by %.1e, pressures by %.1e", nx, ny, difference, off);
  }
}

// What typical gears have: nearly line contacts with thin films. From nothing, Newton's method must not find the film's
// edge node by node, nor the multigrid diverge on the lines near the tips of the ellipse.
TEST(Stationary, thin_films_of_slender_contacts_take_few_iterations) {
  for (const auto& [M, L, D] : {std::tuple{2e5, 5.0, 0.001}, {2.5e4, 12.0, 0.0035}}) {
    for (const auto& [nx, ny] : {std::pair{129, 65}, {257, 65}, {257, 129}}) {
      const SolvedFilm solved(PETSC_COMM_WORLD, moes_contact(M, L, D), nx, ny);
      const SolveCounts& counts = solved.result.counts;
      const double solves = counts.newton;
      report("M %g L %g D %g, %d x %d: %d Newton iterations, %.1f Krylov iterations each", M, L, D, nx, ny,
             counts.newton, counts.krylov / solves);
      EXPECT_LE(counts.newton, 15);
      EXPECT_LE(counts.krylov, 8.0 * solves);
    }
  }
}

// From a coarser grid's film alone a node among large pressures may end empty, which Newton's method does not undo.
TEST(Stationary, films_where_contacts_enter_are_found_at_any_displacement) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_WORLD,
                  grid_shape({.x_min = -2.083, .x_max = 1.667, .y_half = 1.6}, pitch.scales.hertz.ellipticity, 73, 33));
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  move_surfaces(film, {.relative_radius = 0.838367, .entrainment = 0.948058});
  for (double H0 = -2.0; H0 < -1.6; H0 += 0.05) {
    const auto found = solve_stationary(film, LoadCondition::displacement(H0), SolverOptions{});
    EXPECT_GT(found.quantities.smallest_film, 0.0) << "H0 = " << H0;
    EXPECT_LT(found.counts.residual, SolverOptions{}.newton.tolerance) << "H0 = " << H0;
  }
}

TEST(Stationary, pressure_and_flow_are_complementary) {
  SolvedFilm solved(PETSC_COMM_WORLD, table3_pitch(), 65, 33);
  const auto& [pressure, H0] = solved.result.solution;
  // A squeeze rate so negative that every inner node is full shows R itself, less that rate.
  constexpr double suction = 1e6;
  const std::vector<double> sucking(pressure.size(), -suction);
  std::vector<double> residual(pressure.size());
  solved.film.residual(pressure, H0, {sucking}, residual);
  int counts[2] = {0, 0};
  for (int i = 0; i < solved.grid.nx(); ++i) {
    for (int j = 0; j < solved.grid.y_count(); ++j) {
      if (solved.grid.is_boundary(i, j)) continue;
      const int n = i * solved.grid.y_count() + j;
      const double flow = residual[n] + suction;
      // A root mean square residual of 1e-8 is at most 5e-7 at one of 1105 nodes; d P >= 0.9 P.
      EXPECT_NEAR(std::min(pressure[n], flow), 0.0, 1e-6);
      ++counts[pressure[n] > flow];
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  report("%d cavitated, %d full nodes", counts[0], counts[1]);
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 500);
}

// Away from the pitch R_x and u_m differ from the reference ones. In SI it must not matter which place the scales
// are taken from.
TEST(Stationary, film_at_another_place_does_not_depend_on_the_reference_of_the_scales) {
  const LineOfAction line(table3::gear_pair());
  const FilmCase pitch = table3_pitch();
  const double xi = 3e-3;
  ContactSolids solids = pitch.scales.solids;
  solids.radius_x = line.radius_x(xi);
  const ContactOperation operation{.load = pitch.scales.operation.load,
                                   .entrainment_velocity = line.entrainment_velocity(xi, table3::pinion_speed)};
  const Scales own = make_scales(solids, pitch.scales.oil, operation);

  const GridShape shape = pitch.shape(65, 33);
  const Grid grid(PETSC_COMM_WORLD, shape);
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  constexpr double offset = 0.01;
  move_surfaces(film, {.relative_radius = solids.radius_x / pitch.scales.solids.radius_x,
                       .entrainment = operation.entrainment_velocity / pitch.scales.operation.entrainment_velocity,
                       .gap_offset = offset});
  const auto result = solve_stationary(film, LoadCondition::force(pitch.scales.static_force), SolverOptions{});

  const double ratio = pitch.scales.length / own.length;
  const Grid own_grid(PETSC_COMM_WORLD, rectangle(shape.nx, shape.ny(), ratio * shape.x_min, ratio * shape.x_max,
                                                  ratio * shape.row_axis.half_width()));
  ContactFilm own_film(discretise(own_grid, own), own, MultigridOptions{});
  const auto own_result = solve_stationary(own_film, LoadCondition::force(own.static_force), SolverOptions{});

  // Two solutions to a residual of 1e-8.
  constexpr double tolerance = 1e-6;
  const double h = own.thickness * own_result.quantities.central_film,
               h_min = own.thickness * own_result.quantities.smallest_film;
  EXPECT_NEAR(pitch.scales.thickness * result.quantities.central_film, h, tolerance * h);
  EXPECT_NEAR(pitch.scales.thickness * result.quantities.smallest_film, h_min, tolerance * h_min);
  const double p = own.pressure * own_result.quantities.largest_pressure;
  EXPECT_NEAR(pitch.scales.pressure * result.quantities.largest_pressure, p, tolerance * p);
  // H_0 falls by the offset that is added to the gap.
  EXPECT_NEAR(pitch.scales.thickness * (result.solution.H0 + offset), own.thickness * own_result.solution.H0,
              tolerance * h);
}

class StationaryLoad : public testing::Test {
protected:
  const FilmCase pitch = table3_pitch();
  const double force = pitch.scales.static_force;
  SolvedFilm under_force{PETSC_COMM_WORLD, pitch, 65, 33};
  ContactFilm film{under_force.film.discretisation(), pitch.scales, MultigridOptions{}};

  void expect_same_film(const StationaryResult& result) {
    // Two solutions to a residual of 1e-8.
    constexpr double tolerance = 1e-6;
    const auto& expected = under_force.result;
    EXPECT_NEAR(result.solution.H0, expected.solution.H0, tolerance);
    EXPECT_NEAR(result.quantities.pressure_integral, force, tolerance * force);
    EXPECT_NEAR(result.quantities.smallest_film, expected.quantities.smallest_film,
                tolerance * expected.quantities.smallest_film);
  }
};

TEST_F(StationaryLoad, displacement_of_a_film_gives_back_its_force) {
  const auto at_H0 = LoadCondition::displacement(under_force.result.solution.H0);
  expect_same_film(solve_stationary(film, at_H0, SolverOptions{}));
}

TEST_F(StationaryLoad, film_does_not_depend_on_where_it_is_continued_from) {
  const auto condition = LoadCondition::force(force);
  const auto near = solve_stationary(film, LoadCondition::force(0.8 * force), SolverOptions{});
  const auto continued = continue_stationary(film, condition, SolverOptions{}, near.solution);
  EXPECT_EQ(continued.by_grid.size(), 1U);  // from its guess, not from nothing
  expect_same_film(continued);
  const FilmSolution unloaded{std::vector<double>(under_force.grid.local_size(), 0.0), 0.0};
  expect_same_film(continue_stationary(film, condition, SolverOptions{}, unloaded));
}

TEST_F(StationaryLoad, film_does_not_depend_on_limited_changes) {
  SolverOptions options;
  options.newton.limit_changes = true;
  const auto near = solve_stationary(film, LoadCondition::force(0.99 * force), SolverOptions{});
  const auto continued = continue_stationary(film, LoadCondition::force(force), options, near.solution);
  EXPECT_EQ(continued.by_grid.size(), 1U);
  expect_same_film(continued);
}

// Five Hertz approaches apart: only the wedge of the inlet is left, less than a thousandth of the load.
TEST_F(StationaryLoad, separated_bodies_carry_next_to_nothing) {
  const auto apart = LoadCondition::displacement(5.0 * pitch.scales.approach);
  const auto result = solve_stationary(film, apart, SolverOptions{});
  EXPECT_GT(result.quantities.pressure_integral, 1e-9 * force);
  EXPECT_LT(result.quantities.pressure_integral, 1e-3 * force);
}

}  // namespace
}  // namespace gearfilm

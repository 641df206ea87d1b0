// Stationary films between rough surfaces: limits, derivatives, and the same film on any number of processes.
#include <fstream>

#include "placed_film.hpp"

namespace gearfilm {
namespace {

/// A contact with surfaces of so much roughness, as a part of a^2/R_x.
FilmCase rough(FilmCase contact, double part, RoughOptions options = {}) {
  const double one = part * contact.scales.thickness / std::sqrt(2.0);
  if (options.roughness[0] == 0.0) options.roughness = {one, one};
  contact.scales.solids.rough = std::make_shared<const RoughSurfaces>(options, contact.scales.solids.reduced_modulus);
  return contact;
}

TEST(RoughFilm, of_vanishing_roughness_is_that_of_smooth_surfaces) {
  const FilmCase smooth = moes_contact(200.0, 10.0, 0.5);
  SolverOptions exact;
  exact.newton.tolerance = 1e-11;
  const SolvedFilm expected(PETSC_COMM_WORLD, smooth, 65, 33, exact);
  const FilmCase nearly = rough(smooth, 1e-12);
  const Grid grid(PETSC_COMM_WORLD, nearly.shape(65, 33));
  ContactFilm film(discretise(grid, nearly.scales), nearly.scales, exact.multigrid);
  const auto found =
      continue_stationary(film, LoadCondition::force(nearly.scales.static_force), exact, expected.result.solution);
  EXPECT_NEAR(found.quantities.central_film / expected.result.quantities.central_film, 1.0, 1e-8);
  EXPECT_NEAR(found.quantities.smallest_film / expected.result.quantities.smallest_film, 1.0, 1e-8);
  EXPECT_EQ(found.quantities.asperity_integral, 0.0);
}

/// Flanks of different roughness and lay that slide on each other.
struct SlidingFilm {
  SlidingFilm() {
    film.set_surfaces(surfaces_of(grid, contact.scales, {.sliding = 0.4}));
    result = solve_stationary(film, LoadCondition::force(contact.scales.static_force), {});
  }

  FilmCase contact = [] {
    const FilmCase smooth = moes_contact(200.0, 10.0, 0.5);
    const double unit = smooth.scales.thickness;
    return rough(smooth, 0.0, {.roughness = {0.05 * unit, 0.02 * unit}, .lay = {0.5, 2.0}});
  }();
  Grid grid{PETSC_COMM_WORLD, contact.shape(65, 33)};
  ContactFilm film{discretise(grid, contact.scales), contact.scales, MultigridOptions{}};
  StationaryResult result;
};

// Only changes of full nodes whose neighbours are full: the oil of dry ones has a kink where its pressure vanishes.
TEST(RoughFilm, jacobian_passes_taylor_test) {
  const SlidingFilm solved;
  EXPECT_GT(solved.result.quantities.asperity_integral, 0.03 * solved.result.quantities.pressure_integral);
  const Grid& grid = solved.grid;
  ContactFilm film(solved.film.discretisation(), solved.contact.scales, {.precision = Precision::double_precision});
  film.set_surfaces(solved.film.surfaces());
  const std::vector<double>& pressure = solved.result.solution.pressure;
  const double H0 = solved.result.solution.H0;
  const std::size_t size = pressure.size();
  std::vector<double> change(size, 0.0), slope(size), at_state(size);
  film.residual(pressure, H0, {}, at_state);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      const double full = film.state().full_film.row(i)[j];
      const std::size_t n = static_cast<std::size_t>(i) * grid.y_count() + j;
      change[n] = full * 1e-2 * film.film_pressure().row(i)[j] * std::sin(2.3 * grid.x(i) + 0.9 * grid.y(j));
    }
  }
  film.linearise(pressure, H0, {}, 0.0);
  film.multiply(change, 0.0, slope);
  // Where the oil is full well within the contact.
  const auto counts = [&](int i, int j) {
    return std::abs(grid.x(i)) < 0.7 && std::abs(grid.y(j)) < 0.7 * grid.shape().row_axis.half_width() / 3.0;
  };
  double before = 0.0;
  for (const double step : {0.4, 0.2, 0.1}) {
    std::vector<double> moved(pressure), remainder(size);
    for (std::size_t n = 0; n < size; ++n) moved[n] += step * change[n];
    film.residual(moved, H0, {}, remainder);
    double sum = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        const std::size_t n = static_cast<std::size_t>(i) * grid.y_count() + j;
        const double left = remainder[n] - at_state[n] - step * slope[n];
        if (counts(i, j)) sum += left * left;
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(std::sqrt(before / sum)), 2.0, 0.1);
    }
    before = sum;
  }
}

TEST(RoughFilm, is_the_same_on_any_number_of_processes) {
  const SlidingFilm together;
  const SolvedFilm alone(PETSC_COMM_SELF, rough(moes_contact(200.0, 10.0, 0.5), 0.05), 65, 33);
  const SolvedFilm shared(PETSC_COMM_WORLD, rough(moes_contact(200.0, 10.0, 0.5), 0.05), 65, 33);
  EXPECT_NEAR(shared.result.quantities.central_film, alone.result.quantities.central_film, 1e-8);
  EXPECT_NEAR(shared.result.quantities.asperity_integral, alone.result.quantities.asperity_integral, 1e-7);
  EXPECT_TRUE(together.result.quantities.finite);
}

// From 1 to 1/1000 of the speed in thirds of a decade: from films that carry nearly all of the load to dry asperities.
TEST(RoughFilm, follows_from_its_neighbour_in_eight_iterations_on_the_average) {
  const FilmCase contact = rough(moes_contact(200.0, 10.0, 0.5), 0.05);
  const Grid grid(PETSC_COMM_WORLD, contact.shape(65, 33));
  ContactFilm film(discretise(grid, contact.scales), contact.scales, MultigridOptions{});
  const LoadCondition load = LoadCondition::force(contact.scales.static_force);
  StationaryResult last = solve_stationary(film, load, {});
  const double first_share = last.quantities.asperity_integral / last.quantities.pressure_integral;
  constexpr int count = 9;
  int iterations = 0;
  for (int n = 1; n <= count; ++n) {
    move_surfaces(film, {.entrainment = std::pow(10.0, -n / 3.0)});
    const std::optional<StationaryResult> next = improve_stationary(film, load, {}, last.solution);
    ASSERT_TRUE(next) << "at the speed 10^-" << n / 3.0;
    iterations += next->counts.newton;
    EXPECT_GT(next->quantities.asperity_integral, last.quantities.asperity_integral);
    last = *next;
  }
  EXPECT_LT(first_share, 0.3);
  EXPECT_GT(last.quantities.asperity_integral / last.quantities.pressure_integral, 0.9);
  EXPECT_LE(iterations, 8 * count);
  report("  %.1f Newton iterations a film", static_cast<double>(iterations) / count);
}

// D = c y.
TEST(ContactSurfaces, part_by_what_flanks_lack_beside_the_middle_of_the_face) {
  const FilmCase contact = moes_contact(200.0, 10.0, 0.5);
  const Grid grid(PETSC_COMM_WORLD, contact.shape(17, 9));
  constexpr double c = 1e-3, far = 1.0;
  const std::vector<FlankCurve> curves = {{{0.01, -c * far}}, {{0.01, 0.0}}, {{0.01, c * far}}};
  ContactConditions conditions;
  const std::vector<double> even = surfaces_of(grid, contact.scales, conditions).gap;
  conditions.beside_middle = {std::make_shared<const std::array<UnevenFlank, 2>>(
                                  std::array{UnevenFlank({-far, 0.0, far}, curves), UnevenFlank()}),
                              {0.01, 0.02},
                              {0.03, 0.05}};
  const std::vector<double> uneven = surfaces_of(grid, contact.scales, conditions).gap;
  for (std::size_t n = 0; n < even.size(); ++n) {
    const double y = grid.y(static_cast<int>(n) % grid.y_count()) * contact.scales.length;
    EXPECT_NEAR(uneven[n] - even[n], c * y / contact.scales.thickness, 1e-12);
  }
}

// Hardness 0.01 E', sigma = 2e-5 R_x.
TEST(RoughFilm, without_oil_is_the_dry_contact_of_rough_surfaces) {
  constexpr double modulus = 2.26e11, radius = 0.01;
  const auto reference =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/rough.json")).at("dry_ellipses");
  for (const auto& row : reference) {
    ContactSolids solids{
        .radius_x = radius, .radius_y = radius / row.at("D").get<double>(), .reduced_modulus = modulus};
    const double one = 2e-5 * radius / std::sqrt(2.0);
    RoughOptions options{.roughness = {one, one}};
    options.asperities.hardness = 0.01 * modulus;
    solids.rough = std::make_shared<const RoughSurfaces>(options, modulus);
    const Scales scales =
        make_scales(solids, {.viscosity = 0.04, .pressure_viscosity = 2e-8},
                    {.load = row.at("W").get<double>() * modulus * radius * radius, .entrainment_velocity = 0.5});
    const FilmCase contact{scales, {-2.0, 2.0, 2.0}};
    const Grid grid(PETSC_COMM_WORLD, contact.shape(97, 65));
    ContactFilm film(discretise(grid, scales), scales, MultigridOptions{});
    FilmSolution solution{std::vector<double>(grid.local_size()), 0.0};
    hertz_pressure(grid, scales, dry_contact(scales, film.conditions(), scales.static_force), solution.pressure);
    const double touching = scales.solids.rough->asperities().gap_under(0.9 * scales.pressure);
    solution.H0 = touching * scales.solids.rough->sigma() / scales.thickness -
                  film.quantities(solution.pressure, 0.0).central_film;
    film.set_without_oil(true);
    StationaryNewton newton({&film}, {});
    ASSERT_TRUE(newton.solve(LoadCondition::force(scales.static_force), solution));
    EXPECT_LE(newton.counts().newton, 6);
    const FilmQuantities found = newton.quantities().front();
    EXPECT_NEAR(found.largest_pressure, row.at("Pmax").get<double>(), 0.002);
    // P = P_a at every node.
    newton.aim_at(1e-13);
    ASSERT_TRUE(newton.solve(LoadCondition::force(scales.static_force), solution));
    EXPECT_LT(maximum(largest(whole_of(grid, film.film_pressure()))), 1e-10);
  }
}

}  // namespace
}  // namespace gearfilm

// Films that must not be believed, and solves that fail, end with a SolveError.
#include "film/validity.hpp"

#include "film_case.hpp"

namespace gearfilm {
namespace {

void expect_mentions(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

const std::string where = "contact 1 at xi = -2.5 mm";

class Validity : public testing::Test {
protected:
  /// The dry film of `force_ratio` times the static load, raised by `gap`, on a domain.
  std::string message_for(const Domain& domain, double force_ratio, double gap) {
    const FilmCase pitch = table3_pitch();
    const Grid grid(PETSC_COMM_WORLD, grid_shape(domain, pitch.scales.hertz.ellipticity, 65, 33));
    ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
    const HertzContact dry = dry_contact(pitch.scales, film.conditions(), force_ratio * pitch.scales.static_force);
    std::vector<double> pressure(grid.local_size());
    hertz_pressure(grid, pitch.scales, dry, pressure);
    const FilmQuantities quantities = film.quantities(pressure, gap - dry.approach / pitch.scales.thickness);
    return solve_error_of([&] { check_validity(film, quantities, where); });
  }
};

TEST_F(Validity, accepts_a_converged_film) {
  const SolvedFilm solved(PETSC_COMM_WORLD, table3_pitch(), 65, 33);
  EXPECT_NO_THROW(check_validity(solved.film, solved.result.quantities, where));
}

TEST_F(Validity, accepts_a_contact_without_load) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_WORLD, pitch.shape(65, 33));
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  const std::vector<double> pressure(grid.local_size(), 0.0);
  EXPECT_NO_THROW(check_validity(film, film.quantities(pressure, 1.0), where));
}

// Under twice the load the ellipse grows by 2^(1/3) = 1.26.
TEST_F(Validity, refuses_an_ellipse_that_reaches_the_side) {
  const std::string message = message_for({.x_min = -2.083, .x_max = 1.5, .y_half = 1.1}, 2.0, 0.3);
  EXPECT_TRUE(message.starts_with(where)) << message;
  expect_mentions(message, "side edge");
  expect_mentions(message, "grid_y_half");
}

TEST_F(Validity, refuses_an_ellipse_that_reaches_the_outlet) {
  const std::string message = message_for({.x_min = -2.083, .x_max = 1.2, .y_half = 2.0}, 2.0, 0.3);
  EXPECT_TRUE(message.starts_with(where)) << message;
  expect_mentions(message, "outlet edge");
  expect_mentions(message, "grid_x_max");
}

TEST_F(Validity, refuses_an_ellipse_that_reaches_the_inlet) {
  const std::string message = message_for({.x_min = -1.2, .x_max = 1.5, .y_half = 2.0}, 2.0, 0.3);
  EXPECT_TRUE(message.starts_with(where)) << message;
  expect_mentions(message, "inlet edge");
  expect_mentions(message, "grid_x_min");
}

// The same check, before any film of that force is computed.
TEST_F(Validity, refuses_a_domain_that_is_too_small_for_a_force) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_WORLD, pitch.shape(65, 33));
  const auto check = [&](double force_ratio) {
    check_domain(grid, pitch.scales, ContactConditions{}, force_ratio * pitch.scales.static_force, where);
  };
  // |y| <= 1.1 b holds to 1.1^3 = 1.331 times the load.
  EXPECT_NO_THROW(check(1.33));
  expect_mentions(solve_error_of([&] { check(1.332); }), "side edge");
}

TEST_F(Validity, refuses_a_film_that_is_not_positive) {
  const std::string message = message_for({.x_min = -2.083, .x_max = 1.5, .y_half = 1.5}, 1.0, -0.05);
  EXPECT_TRUE(message.starts_with(where)) << message;
  expect_mentions(message, "not positive");
}

TEST_F(Validity, refuses_a_film_that_is_not_a_number) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_WORLD, pitch.shape(65, 33));
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  std::vector<double> pressure(grid.local_size(), 0.0);
  if (grid.rank() == grid.processes() - 1) pressure[grid.local_size() / 2] = std::nan("");
  const std::string message = solve_error_of([&] { check_validity(film, film.quantities(pressure, 1.0), where); });
  EXPECT_TRUE(message.starts_with(where)) << message;
  expect_mentions(message, "not finite");
}

TEST(StationaryFailure, raises_an_error_that_names_the_grid_and_the_remedy) {
  SolverOptions options;
  options.newton.max_iterations = 1;
  const std::string message = solve_error_of([&] { SolvedFilm(PETSC_COMM_WORLD, table3_pitch(), 65, 33, options); });
  expect_mentions(message, "not converged");
  expect_mentions(message, "65 x 33");
  expect_mentions(message, "solver_newton_max_iterations");
}

TEST(StationaryFailure, more_processes_than_rows_is_a_wrong_input) {
  int processes = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &processes);
  if (processes < 3) GTEST_SKIP() << "needs 3 processes";
  const std::string message =
      table3::input_error_of([&] { Grid(PETSC_COMM_WORLD, rectangle(33, 2 * processes - 3, -2.0, 1.0, 1.0)); });
  expect_mentions(message, "ny = " + std::to_string(2 * processes - 3));
}

}  // namespace
}  // namespace gearfilm

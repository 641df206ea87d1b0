// The map that a pushed pair follows back to its orbit, from motions that are known.
#include "orbits/free_decay.hpp"

#include <cmath>

#include "orbits/multiplier_error.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

const Motion orbit_begin{-1.5, 1.3};
const Motion orbit_end{-1.5 + 2e-5, 1.3 - 3e-5};  // the orbit's own defect

Motion mapped(const Monodromy& map, const Motion& from) {
  return to_motion(to_vector(orbit_end) + map * to_vector(difference(from, orbit_begin)));
}

/// After a push of H_0, the first period's films being slow to follow; with errors of the given size.
Returns returns(const Monodromy& map, int periods, double noise, double push = 5e-3) {
  Returns motions = {{orbit_begin.H0() + push, orbit_begin.V0()}};
  for (int n = 1; n <= periods; ++n) {
    Motion next = mapped(map, motions.back());
    if (n == 1) next.V0() += 4e-4;
    const double sign = n % 2 == 0 ? 1.0 : -1.0;
    motions.push_back({next.H0() + sign * noise, next.V0() - (n % 3 == 0 ? 1.0 : 0.4) * noise});
  }
  return motions;
}

Monodromy rotation(double modulus, double angle) {
  const double c = modulus * std::cos(angle), s = modulus * std::sin(angle);
  return Monodromy{{c, s / 6.0}, {-6.0 * s, c}};
}

TEST(FreeDecay, of_a_linear_map_gives_its_multipliers) {
  const FreeDecay decay = fit_decay({returns(rotation(0.95, 2.05), 4, 0.0)}, orbit_begin, orbit_end);
  EXPECT_NEAR(std::abs(decay.multipliers[0]), 0.95, 1e-10);
  EXPECT_NEAR(std::arg(decay.multipliers[0]), 2.05, 1e-10);
  EXPECT_LT(decay.modulus_error(), 1e-10);
}

TEST(FreeDecay, says_by_how_much_it_may_err) {
  for (const double noise : {1e-6, 1e-5, 1e-4}) {
    const FreeDecay decay = fit_decay({returns(rotation(0.9, 1.3), 5, noise)}, orbit_begin, orbit_end);
    const double error = std::abs(std::abs(decay.multipliers[0]) - 0.9);
    EXPECT_LT(error, decay.modulus_error());
    EXPECT_LT(decay.modulus_error(), 5e3 * noise);
  }
}

TEST(FreeDecay, of_pushes_both_ways_fits_both) {
  const Monodromy map = rotation(0.95, 2.05);
  const FreeDecay decay = fit_decay({returns(map, 4, 3e-5), returns(map, 4, 3e-5, -5e-3)}, orbit_begin, orbit_end);
  EXPECT_LT(std::abs(std::abs(decay.multipliers[0]) - 0.95), decay.modulus_error());
  // Two maps cannot be fitted by one: their difference is an error.
  const FreeDecay kinked =
      fit_decay({returns(map, 4, 0.0), returns(rotation(0.75, 2.05), 4, 0.0, -5e-3)}, orbit_begin, orbit_end);
  EXPECT_GT(kinked.modulus_error(), 0.05);
}

TEST(FreeDecay, tells_two_real_multipliers_apart) {
  const FreeDecay decay = fit_decay({returns(Monodromy{{-1.2, 0.05}, {0.0, -0.6}}, 4, 0.0)}, orbit_begin, orbit_end);
  std::array<double, 2> found = {decay.multipliers[0].real(), decay.multipliers[1].real()};
  EXPECT_NEAR(std::min(found[0], found[1]), -1.2, 1e-9);
  EXPECT_NEAR(std::max(found[0], found[1]), -0.6, 1e-9);
}

TEST(FreeDecay, that_is_over_at_once_is_known_to_be_small_only) {
  const FreeDecay decay = fit_decay({returns(rotation(1e-3, 2.0), 2, 1e-7)}, orbit_begin, orbit_end);
  EXPECT_LT(std::abs(decay.multipliers[0]), 0.1);
  EXPECT_DOUBLE_EQ(decay.modulus_error(), std::max(std::abs(decay.multipliers[0]), std::abs(decay.multipliers[1])));
}

OrbitProblem problem_on(int nx, int ny) {
  return orbit_problem(table3_case({{"grid.nx", std::to_string(nx)}, {"grid.ny", std::to_string(ny)}}));
}

TEST(MultiplierError, falls_with_the_square_of_the_error_of_films) {
  const OrbitProblem coarse = problem_on(513, 257), fine = problem_on(1025, 513);
  const double films = film_errors(coarse).smallest / film_errors(fine).smallest;
  ASSERT_LT(film_errors(coarse).smallest, 0.04);
  EXPECT_GT(films, 2.0);
  const Multipliers swings = {std::polar(0.9, 1.3), std::polar(0.9, -1.3)};
  EXPECT_NEAR(multiplier_grid_error(coarse, swings) / multiplier_grid_error(fine, swings), films * films, 1e-9);
}

TEST(MultiplierError, is_one_of_damping_where_the_pair_swings) {
  const OrbitProblem coarse = problem_on(33, 17);  // whose films err by more than tells
  const auto error_of = [&](const Multipliers& multipliers) { return multiplier_grid_error(coarse, multipliers); };
  EXPECT_NEAR(error_of({std::polar(0.9, 1.3), std::polar(0.9, -1.3)}), 0.3 * 0.9 * std::log(1.0 / 0.9), 1e-12);
  EXPECT_NEAR(error_of({1.7, 0.3}), 0.2 * 1.7, 1e-12);
  EXPECT_EQ(error_of({0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace gearfilm

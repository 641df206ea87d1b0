// The body equations: their rows in each kind, and their solution together with films that give way.
#include "gearfilm/ehl/body_equations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearfilm/parallel/dense_factors.hpp"

namespace gearfilm {
namespace {

using Values = std::vector<double>;

constexpr double inertia = 31.0, static_force = 15.0, share = 0.4;

TEST(BodyEquations, rows_vanish_where_it_is_in_balance) {
  EXPECT_EQ(fixed_approach(-0.7).rows(Values{-0.7}, Values{3.0}, 99.0, BodyEquations::Of::states), Values{0.0});
  EXPECT_EQ(load_balance(8.0).rows(Values{-0.7}, Values{3.0}, 8.0, BodyEquations::Of::states), Values{0.0});
  // Falling at 0.2, sped up by a force that is larger than the share of the static one.
  const double force = share * 1.5 * static_force, acceleration = 0.5 * static_force / inertia;
  const Values rows = equation_of_motion(inertia, static_force, share)
                          .rows(Values{-0.7, -0.2}, Values{-0.2, acceleration}, force, BodyEquations::Of::states);
  for (const double row : rows) EXPECT_NEAR(row, 0.0, 1e-15);
}

TEST(BodyEquations, rows_are_relative_errors) {
  EXPECT_NEAR(load_balance(8.0).rows(Values{0.0}, Values{0.0}, 8.8, BodyEquations::Of::states)[0], -0.1, 1e-15);
  const BodyEquations pair = equation_of_motion(inertia, static_force, share);
  EXPECT_NEAR(pair.rows(Values{0.0, 0.0}, Values{0.0, 0.0}, 0.9 * share * static_force, BodyEquations::Of::states)[1],
              0.1, 1e-15);
}

// The films' forces fall by their stiffness times the displacement.
TEST(BodyEquations, solution_fulfils_the_rows) {
  constexpr double shift = 7.0, film_stiffness = 13.0;
  for (const BodyEquations& bodies :
       {fixed_approach(-0.7), load_balance(8.0), equation_of_motion(inertia, static_force, share),
        equation_of_motion(0.0, static_force, share)}) {
    Values wanted(bodies.size());
    for (std::size_t n = 0; n < wanted.size(); ++n) wanted[n] = 0.3 - 0.8 * static_cast<double>(n);
    DenseFactors factors;
    factors.factor(body_matrix(bodies, 1.0, 99.0));  // made again below
    factors.factor(body_matrix(bodies, shift, film_stiffness));
    const Values scalars = factors.solve(wanted);
    Values rates = scalars;
    for (double& rate : rates) rate *= shift;
    const Values rows =
        bodies.rows(scalars, rates, -film_stiffness * bodies.displaced(scalars), BodyEquations::Of::changes);
    for (std::size_t n = 0; n < wanted.size(); ++n) EXPECT_NEAR(rows[n], wanted[n], 1e-13);
  }
}

// Films that have all parted carry nothing, wherever they are held: a failed step, not the end of the program.
TEST(BodyEquations, that_nothing_holds_has_no_solution) {
  DenseFactors factors;
  factors.factor({0.0, 0.0, 1.0, 2.0});
  for (const double scalar : factors.solve({1.0, 1.0})) EXPECT_TRUE(std::isnan(scalar));
  factors.factor({2.0, 0.0, 0.0, 4.0});
  EXPECT_EQ(factors.solve({1.0, 1.0}), (Values{0.5, 0.25}));
}

}  // namespace
}  // namespace gearfilm

// The body equations: their rows in each kind, and their solution together with films that give way.
#include "solver/body_equations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr PairLoad shared_pair{.inertia = 31.0, .static_force = 15.0, .share = 0.4};

VectorXd vector_of(std::initializer_list<double> list) {
  return Eigen::Map<const VectorXd>(list.begin(), static_cast<Eigen::Index>(list.size()));
}

/// Largest entry.
double largest_entry(const MatrixXd& rows) { return rows.cwiseAbs().maxCoeff(); }

TEST(BodyEquations, rows_vanish_in_balance) {
  EXPECT_EQ(largest_entry(fixed_approach(-0.7, 2).rows(vector_of({-0.7}), vector_of({3.0}), vector_of({99.0, 1.0}))),
            0.0);
  EXPECT_EQ(largest_entry(load_balance(8.0, 2).rows(vector_of({-0.7}), vector_of({3.0}), vector_of({6.0, 2.0}))), 0.0);
  // Falling at 0.2, sped up by a force that is larger than the share of the static one.
  const double force = shared_pair.share * 1.5 * shared_pair.static_force,
               acceleration = 0.5 * shared_pair.static_force / shared_pair.inertia;
  const VectorXd rows =
      equation_of_motion(shared_pair, 2)
          .rows(vector_of({-0.7, -0.2}), vector_of({-0.2, acceleration}), vector_of({0.25 * force, 0.75 * force}));
  EXPECT_LT(largest_entry(rows), 1e-15);
}

TEST(BodyEquations, rows_are_relative_errors) {
  EXPECT_NEAR(load_balance(8.0, 1).rows(vector_of({0.0}), vector_of({0.0}), vector_of({8.8}))[0], -0.1, 1e-15);
  const VectorXd rows = equation_of_motion(shared_pair, 1)
                            .rows(vector_of({0.0, 0.0}), vector_of({0.0, 0.0}),
                                  vector_of({0.9 * shared_pair.share * shared_pair.static_force}));
  EXPECT_NEAR(rows[1], 0.1, 1e-15);
}

TEST(BodyEquations, displace_all_films_of_a_pair_alike) {
  for (const BodyEquations& bodies :
       {fixed_approach(-0.7, 3), load_balance(8.0, 3), equation_of_motion(shared_pair, 3)}) {
    VectorXd scalars = VectorXd::Constant(bodies.size(), 0.3);
    scalars[0] = -0.7;
    EXPECT_EQ(bodies.displacement * scalars, VectorXd::Constant(3, -0.7));
  }
}

// The films' forces fall by their stiffness times the displacement.
TEST(BodyEquations, solution_fulfils_the_rows) {
  constexpr double shift = 7.0;
  const VectorXd stiffness = vector_of({13.0, 5.0});
  PairLoad without_inertia = shared_pair;
  without_inertia.inertia = 0.0;
  for (const BodyEquations& bodies : {fixed_approach(-0.7, 2), load_balance(8.0, 2), equation_of_motion(shared_pair, 2),
                                      equation_of_motion(without_inertia, 2)}) {
    const VectorXd wanted = VectorXd::LinSpaced(bodies.size(), 0.3, -0.5);
    const MatrixXd film_stiffness = stiffness.asDiagonal() * bodies.displacement;
    const VectorXd scalars = solved(bodies.jacobian(shift, film_stiffness), wanted);
    const VectorXd rows = bodies.rows_of_change(scalars, shift * scalars, -film_stiffness * scalars);
    EXPECT_LT(largest_entry(rows - wanted), 1e-13);
  }
}

TEST(BodyEquations, reverse_flanks_have_a_row_and_a_column_of_their_own) {
  const VectorXd scalars = vector_of({0.4, -0.3, 2.0});
  EXPECT_EQ(ReverseFlankForce().rows(scalars), VectorXd::Zero(3));
  EXPECT_EQ(ReverseFlankForce().jacobian(scalars), MatrixXd::Zero(3, 3));
  const ReverseFlankForce reverse{[](double h) {
                                    return ReverseFlankForce::Value{h * h, 2.0 * h};
                                  },
                                  vector_of({1.0, -2.0, 0.0}).transpose(), vector_of({0.0, 0.5, 3.0})};
  EXPECT_LT(largest_entry(reverse.rows(scalars) - vector_of({0.0, 0.5, 3.0})), 1e-15);  // h = 1
  EXPECT_LT(largest_entry(reverse.jacobian(scalars) - MatrixXd{{0.0, 0.0, 0.0}, {1.0, -2.0, 0.0}, {6.0, -12.0, 0.0}}),
            1e-14);
}

// Films that have all parted carry nothing, wherever they are held: a failed step, not the end of the program.
TEST(BodyEquations, that_nothing_holds_have_no_solution) {
  const VectorXd ones = VectorXd::Ones(2);
  for (const double scalar : solved(MatrixXd{{0.0, 0.0}, {1.0, 2.0}}, ones)) {
    EXPECT_TRUE(std::isnan(scalar));
  }
  EXPECT_EQ(solved(MatrixXd{{2.0, 0.0}, {0.0, 4.0}}, ones), vector_of({0.5, 0.25}));
}

}  // namespace
}  // namespace gearfilm

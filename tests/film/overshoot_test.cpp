// The part that a node takes of a change of which it has overshot.
#include "film/overshoot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearfilm {
namespace {

/// A row whose flow grows as exp(stiffness m): linear prediction expected (1 - m), and what is beyond it.
double row(double expected, double strength, double stiffness, double part) {
  return expected * (1.0 - part) - strength * (std::expm1(stiffness * part) - stiffness * part);
}

TEST(Overshoot, a_node_takes_the_part_at_which_its_own_row_vanishes) {
  for (const double stiffness : {0.5, 5.0, 25.0}) {
    for (const double taken : {1.0, 0.6}) {
      const double expected = 0.7, strength = 1.0;
      const Overshoot node{expected, taken, 0.3, row(expected, strength, stiffness, taken), stiffness * taken};
      if (node.after >= 0.0) continue;
      const double part = part_to_take(node);
      EXPECT_LT(part, taken);
      EXPECT_NEAR(row(expected, strength, stiffness, part), 0.0, 1e-6 * std::abs(node.after)) << stiffness;
    }
  }
}

TEST(Overshoot, a_node_that_lacked_oil_before_takes_half) {
  EXPECT_DOUBLE_EQ(part_to_take({0.7, 1.0, -0.3, -80.0, 6.0}), 0.5);
}

TEST(Overshoot, is_oil_that_comes_in_by_a_conductance_that_has_grown) {
  EXPECT_TRUE(has_overshot({0.7, 1.0, 0.3, -80.0, 6.0}));
  EXPECT_FALSE(has_overshot({0.7, 1.0, 0.3, 80.0, 6.0}));
  EXPECT_FALSE(has_overshot({0.7, 1.0, 0.3, -0.01, 6.0}));
  EXPECT_FALSE(has_overshot({0.7, 1.0, 0.3, -80.0, -6.0}));
}

}  // namespace
}  // namespace gearfilm

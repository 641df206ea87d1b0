// Rates, extrapolated states and errors of backward differences at uneven steps.
#include "dynamics/backward_differences.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/slope_weights.hpp"

namespace gearfilm {
namespace {

OwnedVec two_values() {
  OwnedVec vec;
  petsc_check(VecCreateSeq(PETSC_COMM_SELF, 2, vec.put()));
  return vec;
}

void set(Vec vec, double first, double second) {
  const VecWriting values(vec);
  values[0] = first;
  values[1] = second;
}

double parabola(double T) { return 2.0 - 3.0 * T + 0.5 * T * T; }
double parabola_slope(double T) { return -3.0 + T; }
double cubic(double T) { return T * T * T; }

/// C = 2 state; the state is a parabola and a cubic of time.
struct Course {
  BackwardDifferences differences{two_values};
  OwnedVec rate = two_values(), allowed = two_values();

  void find(double T) { set(differences.sought(), parabola(T), cubic(T)); }
  void know(double T, bool behind = false) {
    find(T);
    differences.keep(T, behind, [](Vec state, Vec values) {
      petsc_check(VecCopy(state, values));
      petsc_check(VecScale(values, 2.0));
    });
  }
  double rate_at(double T, int order, int part) {
    differences.differentiate(T, order);
    set(rate, 2.0 * parabola(T), 2.0 * cubic(T));
    differences.make_rate(rate);
    return VecReading(rate)[part];
  }
};

TEST(BackwardDifferences, are_exact_for_parabolas_at_uneven_steps) {
  Course course;
  course.know(0.0);
  EXPECT_NEAR(course.rate_at(0.3, 1, 0), 2.0 * (parabola(0.3) - parabola(0.0)) / 0.3, 1e-12);
  course.know(0.3, true);
  EXPECT_NEAR(course.rate_at(0.6, 2, 0), 2.0 * parabola_slope(0.6), 1e-12);
  course.know(0.6);
  EXPECT_NEAR(course.rate_at(1.0, 2, 0), 2.0 * parabola_slope(1.0), 1e-12);
  EXPECT_EQ(course.differences.known(), 3);
  EXPECT_EQ(course.differences.time(1), 0.0);  // what came behind it is the last
  course.differences.extrapolate(1.0, 3);
  EXPECT_NEAR(VecReading(course.differences.sought())[0], parabola(1.0), 1e-12);
  course.differences.extrapolate(1.0, 2);
  EXPECT_NEAR(VecReading(course.differences.sought())[0], parabola(0.6) + (parabola(0.6) - parabola(0.0)) / 0.6 * 0.4,
              1e-12);
}

// A state behind the one before it in the list, though later, makes no even step.
TEST(BackwardDifferences, tell_even_steps_and_are_exact_for_cubics) {
  Course course;
  const BackwardDifferences& differences = course.differences;
  course.know(0.0);
  course.know(0.15, true);
  course.know(0.3);
  EXPECT_TRUE(differences.evenly_spaced(0.6, 2));
  EXPECT_FALSE(differences.evenly_spaced(0.6, 3));
  course.know(0.6);
  EXPECT_NEAR(course.rate_at(1.05, 3, 1), 2.0 * 3.0 * 1.05 * 1.05, 1e-12);
  course.know(0.9);
  EXPECT_FALSE(differences.evenly_spaced(1.05, 3));
  EXPECT_TRUE(differences.evenly_spaced(1.2, 3));
}

// Of T^3 the formula of order 2 at equal steps h misses the slope by -2 h^2, and so the state by -2 h^2/(3/(2 h)).
TEST(BackwardDifferences, tell_the_local_error_of_a_step) {
  Course course;
  constexpr double h = 0.1;
  for (int n = 0; n < 3; ++n) course.know(n * h);
  course.find(3.0 * h);
  set(course.allowed, 1.0, 1.0);
  const double missed = 2.0 * h * h / (1.5 / h);
  EXPECT_NEAR(course.differences.error(3.0 * h, 2, course.allowed), missed / std::sqrt(2.0), 1e-12);
  set(course.allowed, 1.0, HUGE_VAL);
  EXPECT_NEAR(course.differences.error(3.0 * h, 2, course.allowed), 0.0, 1e-12);
}

// The weights of orders 1 and 2 as textbooks have them, r = dT/dT_before: 1 and (1 + 2 r)/(1 + r), -(1 + r),
// r^2/(1 + r) over dT. Of an oscillation they make what they make of a state that swings.
TEST(BackwardDifferences, have_the_weights_of_textbooks) {
  const double dT = 0.3, r = dT / 0.2, w = 1.7;
  const std::vector<double> first = slope_weights({1.0, 0.7}), second = slope_weights({1.0, 0.7, 0.5});
  EXPECT_NEAR(first[0] * dT, 1.0, 1e-14);
  EXPECT_NEAR(first[1] * dT, -1.0, 1e-14);
  EXPECT_NEAR(second[0] * dT, (1.0 + 2.0 * r) / (1.0 + r), 1e-14);
  EXPECT_NEAR(second[1] * dT, -(1.0 + r), 1e-14);
  EXPECT_NEAR(second[2] * dT, r * r / (1.0 + r), 1e-14);
  Course course;
  const auto swing = [w](double T) { return std::cos(w * T); };
  course.know(0.5);
  course.know(0.7);
  course.differences.differentiate(1.0, 2);
  const double rate = second[0] * swing(1.0) + second[1] * swing(0.7) + second[2] * swing(0.5);
  EXPECT_NEAR((course.differences.of_oscillation(w, 2) * std::polar(1.0, w)).real(), rate, 1e-13);
}

}  // namespace
}  // namespace gearfilm

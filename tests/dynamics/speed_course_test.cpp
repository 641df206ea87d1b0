// Ramps of speed: phase and time belong to each other, and contacts are where the phase says.
#include "mesh/speed_course.hpp"

#include <gtest/gtest.h>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

TEST(SpeedCourse, phase_is_the_integral_of_the_speed) {
  for (const double ratio : {0.4, 1.0, 2.5}) {
    const SpeedCourse course = SpeedCourse::over_phase(ratio, 70.0);
    EXPECT_NEAR(course.phase(course.duration), 70.0, 1e-12);
    double integral = 0.0;
    constexpr double step = 0.01;
    for (double T = 0.5 * step; T < 1.2 * course.duration; T += step) integral += step * course.speed(T);
    EXPECT_NEAR(course.phase(1.2 * course.duration), integral, 0.02);
    for (const double T : {-3.0, 0.0, 0.3 * course.duration, course.duration, 2.0 * course.duration}) {
      EXPECT_NEAR(course.time(course.phase(T)), T, 1e-11);
    }
  }
}

TEST(SpeedCourse, constant_speed_changes_nothing) {
  const SpeedCourse course;
  EXPECT_EQ(course.phase(1.7), 1.7);
  EXPECT_EQ(course.time(1.7), 1.7);
  EXPECT_EQ(course.speed(1.7), 1.0);
}

}  // namespace
}  // namespace gearfilm

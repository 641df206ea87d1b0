// Where dry contacts along a face end within it.
#include "elasticity/row_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "contact/hertz.hpp"
#include "face_case.hpp"

namespace gearfilm {
namespace {

LoadedFace loaded_under(const Scales& scales, double ratio) {
  const std::array forces = {ratio * scales.static_force};
  return loaded_face(scales, forces, {.first = 0.3, .kink = 0.3, .bend = 0.3, .growth = 1.4, .largest = 1.0});
}

// An ellipse of the half-axes a and b has s^2 = a^2 (1 - (Y/b)^2): its ends are those at +-b, where s^2 falls by 2
// a^2/b.
TEST(LoadedFace, of_a_crowned_contact_ends_as_its_ellipse_does) {
  constexpr double radius_y = 0.5;
  const Scales scales = face_scales(face_with(EndFace::half_space), radius_y);
  for (const double ratio : {0.3, 1.0}) {
    const HertzContact ellipse = hertz_contact({9e-3, radius_y, scales.solids.reduced_modulus}, ratio * face_load);
    const double a = ellipse.a / scales.length, b = ellipse.b / scales.length;
    const LoadedFace face = loaded_under(scales, ratio);
    ASSERT_EQ(face.ends.size(), 2U);
    for (const ContactEnd& end : face.ends) {
      EXPECT_NEAR(std::abs(end.y), b, 0.02 * b);
      EXPECT_NEAR(end.widening, 2.0 * a * a / b, 0.15 * 2.0 * a * a / b);
    }
    EXPECT_EQ(face.ends[0].y, -face.ends[1].y);
    EXPECT_GT(face.reached.upper, b);
    EXPECT_LT(face.reached.upper, b + 2.5);
    EXPECT_EQ(face.reached.lower, -face.reached.upper);
  }
}

TEST(LoadedFace, of_an_uncrowned_one_has_no_ends) {
  const Scales scales = face_scales(face_with(EndFace::half_space));
  const LoadedFace face = loaded_under(scales, 1.0);
  EXPECT_TRUE(face.ends.empty());
  EXPECT_GE(face.reached.upper, 0.5 * face_width / scales.length);
}

// Both flanks part by 30 um over the face: what the load reaches lies at -y, and its one end moves with the force.
TEST(LoadedFace, of_a_misaligned_one_ends_at_one_side) {
  const Scales scales = face_scales(face_with(EndFace::half_space, {.slope = 30e-6 / face_width}));
  const LoadedFace little = loaded_under(scales, 0.1), more = loaded_under(scales, 0.2);
  ASSERT_EQ(little.ends.size(), 1U);
  ASSERT_EQ(more.ends.size(), 1U);
  EXPECT_LT(little.ends[0].y, more.ends[0].y);
  EXPECT_LT(more.ends[0].y, 0.5 * face_width / scales.length);
  EXPECT_LT(more.reached.lower, -0.5 * face_width / scales.length);
}

}  // namespace
}  // namespace gearfilm

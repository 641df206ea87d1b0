// The gap along a face, and contacts without an ellipse.
#include "contact/face.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "contact/line_contact.hpp"
#include "contact/scales.hpp"

namespace gearfilm {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double F = 14e-3;

TEST(FaceGap, is_the_sum_of_slope_reliefs_logarithm_and_tables) {
  const Face face{
      .width = F,
      .gap = {.slope = 2e-3,
              .reliefs = {{.amount = 10e-6, .length = 3e-3, .power = 2}, {.amount = 5e-6, .length = 2e-3, .power = 1}},
              .logarithmic = 0.8e-6,
              .tables = {{{-5e-3, 1e-6}, {0.0, 0.0}, {6e-3, 3e-6}}}}};
  const auto expected = [](double y, double circular, double linear, double table) {
    return 2e-3 * y + 10e-6 * circular * circular + 5e-6 * linear - 0.8e-6 * std::log(1.0 - std::pow(2.0 * y / F, 2)) +
           table;
  };
  const double allowed = 1e-18;  // round-off of sums of 1e-5 m
  EXPECT_NEAR(face(0.0), 0.0, allowed);
  EXPECT_NEAR(face(3e-3), expected(3e-3, 0.0, 0.0, 1.5e-6), allowed);
  EXPECT_NEAR(face(-4.5e-3), expected(-4.5e-3, 0.5e-3 / 3e-3, 0.0, 0.9e-6), allowed);
  EXPECT_NEAR(face(6.5e-3), expected(6.5e-3, 2.5e-3 / 3e-3, 1.5e-3 / 2e-3, 3e-6), allowed);
  EXPECT_NEAR(face(-6.5e-3), expected(-6.5e-3, 2.5e-3 / 3e-3, 1.5e-3 / 2e-3, 1e-6), allowed);
}

TEST(FaceGap, opens_towards_positive_y_with_a_positive_slope) {
  const Face face{.width = F, .gap = {.slope = 10e-6 / F}};
  EXPECT_DOUBLE_EQ(face(0.5 * F), 5e-6);
  EXPECT_DOUBLE_EQ(face(-0.5 * F), -5e-6);
}

TEST(FaceGap, of_a_logarithmic_profile_is_finite_at_the_ends) {
  const Face face{.width = F, .gap = {.logarithmic = 0.8e-6}};
  for (const double y : {-0.5 * F, 0.5 * F}) EXPECT_NEAR(face(y), 0.8e-6 * 9.0 * std::log(10.0), 1e-18);
}

TEST(Face, has_kinks_where_linear_reliefs_begin_and_where_tables_have_points) {
  Face face{.width = F};
  EXPECT_THAT(face.kinks(), IsEmpty());
  face.gap.reliefs = {{.amount = 10e-6, .length = 3e-3, .power = 1}, {.amount = 0.0, .length = 1e-3, .power = 1}};
  EXPECT_THAT(face.kinks(), ElementsAre(DoubleEq(-4e-3), DoubleEq(4e-3)));
  EXPECT_THAT(face.bends(), IsEmpty());
  face.gap.tables = {{{-7e-3, 0.0}, {1e-3, 0.0}, {7e-3, 1e-6}}};  // the ends are none
  EXPECT_THAT(face.kinks(), ElementsAre(DoubleEq(-4e-3), DoubleEq(1e-3), DoubleEq(4e-3)));
  face.gap = {.reliefs = {{.amount = 10e-6, .length = 0.5 * F, .power = 1}}};  // from the middle on
  EXPECT_THAT(face.kinks(), ElementsAre(0.0));
}

TEST(Face, bends_where_circular_reliefs_begin_unless_it_has_a_kink_there) {
  Face face{.width = F, .gap = {.reliefs = {{.amount = 10e-6, .length = 3e-3}, {.amount = 5e-6, .length = 1e-3}}}};
  EXPECT_THAT(face.bends(), ElementsAre(DoubleEq(-6e-3), DoubleEq(-4e-3), DoubleEq(4e-3), DoubleEq(6e-3)));
  EXPECT_THAT(face.kinks(), IsEmpty());
  face.gap.reliefs[1] = {.amount = 5e-6, .length = 3e-3, .power = 1};
  EXPECT_THAT(face.bends(), IsEmpty());
}

TEST(Face, is_symmetric_unless_it_slopes_or_has_tables) {
  Face face{.width = F, .gap = {.reliefs = {{.amount = 10e-6, .length = 3e-3}}, .logarithmic = 1e-6}};
  EXPECT_TRUE(face.symmetric());
  for (const double y : {1e-3, 5e-3, 7e-3}) EXPECT_EQ(face(y), face(-y));
  face.gap.slope = 1e-9;
  EXPECT_FALSE(face.symmetric());
  face.gap = {.tables = {{{0.0, 0.0}, {7e-3, 1e-6}}}};
  EXPECT_FALSE(face.symmetric());
}

TEST(Face, is_plain_between_its_reliefs_alone) {
  Face face{.width = F};
  EXPECT_TRUE(face.plain_around(1e-3, 5.9e-3));
  EXPECT_FALSE(face.plain_around(1e-3, 6.1e-3));
  EXPECT_FALSE(face.plain_around(-1e-3, 6.1e-3));
  face.gap = {.slope = 1e-3, .reliefs = {{.amount = 10e-6, .length = 3e-3}}};
  EXPECT_TRUE(face.plain_around(1e-3, 2.9e-3));
  EXPECT_FALSE(face.plain_around(1e-3, 3.1e-3));
  EXPECT_FALSE(face.plain_around(-1e-3, 3.1e-3));
  face.gap.reliefs[0].amount = 0.0;
  EXPECT_TRUE(face.plain_around(1e-3, 3.1e-3));
  face.gap.logarithmic = 1e-6;
  EXPECT_FALSE(face.plain_around(0.0, 1e-3));
  face.gap = {.tables = {{{-7e-3, 0.0}, {7e-3, 0.0}}}};
  EXPECT_FALSE(face.plain_around(0.0, 1e-3));
}

/// Of the reference numbers of end effects: w' = 4000 N over 14 mm.
struct LongContact {
  explicit LongContact(bool line) {
    solids.line = line;
    if (!line) solids.face = std::make_shared<const Face>(Face{.width = F});
    operation.load = line ? 4000.0 / F : 4000.0;
  }

  ContactSolids solids{.radius_x = 9e-3, .radius_y = HUGE_VAL, .reduced_modulus = 226.3736e9};
  Lubricant oil{.viscosity = 0.04, .pressure_viscosity = 2.2e-8};
  ContactOperation operation{.entrainment_velocity = 10.0};
};

// To the digits that the reference gives.
TEST(LineContact, and_a_loaded_face_have_the_scales_of_the_line_load) {
  for (const bool line : {true, false}) {
    const LongContact contact(line);
    const Scales scales = make_scales(contact.solids, contact.oil, contact.operation);
    EXPECT_NEAR(scales.length, 170.077e-6, 1e-9) << line;
    EXPECT_NEAR(scales.pressure, 1069.47e6, 0.01e6) << line;
    EXPECT_NEAR(scales.thickness, 3.2140e-6, 1e-10) << line;
    EXPECT_NEAR(2.0 * std::numbers::pi * scales.C_h, 1.0, 1e-14) << line;
    const double width = line ? 1.0 : F / scales.length;
    EXPECT_NEAR(scales.static_force, 0.5 * std::numbers::pi * width, 1e-13 * width) << line;
    EXPECT_NEAR(scales.force(scales.static_force), contact.operation.load, 1e-9) << line;
    EXPECT_FALSE(has_ellipse(contact.solids)) << line;
  }
}

// In the middle of the face, a and b of which are those of a strip.
TEST(LineContact, that_is_finite_approaches_by_a_logarithm_of_its_length) {
  const LongContact contact(false);
  const HertzContact hertz = hertz_contact(contact.solids, contact.operation.load);
  EXPECT_NEAR(hertz.approach, 9.01e-6, 0.005e-6);
  EXPECT_DOUBLE_EQ(hertz.b, 0.5 * F);
}

TEST(LineContact, has_the_groups_of_its_line_load) {
  for (const bool line : {true, false}) {
    const LongContact contact(line);
    const MoesGroups groups = moes_groups(contact.solids, contact.oil, contact.operation);
    const double stiffness = 226.3736e9 * 9e-3, speed = 2.0 * 0.04 * 10.0 / stiffness;
    EXPECT_NEAR(groups.M, 4000.0 / F / stiffness / std::sqrt(speed), 1e-13 * groups.M) << line;
    EXPECT_NEAR(groups.L, 2.2e-8 * 226.3736e9 * std::pow(speed, 0.25), 1e-13 * groups.L) << line;
    EXPECT_EQ(groups.D, 0.0) << line;
  }
}

// Of Moes' formula the reference gives four digits, of either oil.
TEST(LineContact, has_the_central_film_of_moes_line_formula) {
  for (const bool line : {true, false}) {
    LongContact contact(line);
    EXPECT_NEAR(expected_central_film(contact.solids, contact.oil, contact.operation), 1.3375e-6, 1e-10) << line;
    contact.oil = {.viscosity = 0.02, .pressure_viscosity = 1.6e-8};
    contact.operation.entrainment_velocity = 3.0;
    EXPECT_NEAR(expected_central_film(contact.solids, contact.oil, contact.operation), 0.2922e-6, 1e-10) << line;
  }
}

}  // namespace
}  // namespace gearfilm

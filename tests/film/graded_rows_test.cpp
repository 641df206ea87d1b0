// Rows over a face, closer to one another at its ends and kinks.
#include "grid/graded_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace gearfilm {
namespace {

/// A face, its kinks, and the ends of contacts on it [a].
struct KinkedFace {
  const char* name;
  double half_width;
  std::vector<double> kinks;
  std::vector<RowPlace> contact_ends{};

  friend std::ostream& operator<<(std::ostream& out, const KinkedFace& face) { return out << face.name; }
};

const std::vector<KinkedFace> faces = {
    {"plain", 41.158, {}},
    {"relieved", 41.158, {-23.519, 23.519}},
    {"unlike_to_both_sides", 41.158, {-30.0, -29.98, 0.3, 11.0}},
    {"half_a_metre_wide", 3000.0, {-2900.0, 2900.0}},
    {"with_contacts_that_end_within", 41.158, {-23.519, 23.519}, {{-31.2, 0.7}, {8.4, 1.3}}}};

/// The places of kinks, of which all want one step.
std::vector<RowPlace> places_of(const std::vector<double>& kinks, double step) {
  std::vector<RowPlace> places;
  for (const double y : kinks) places.push_back({y, step});
  return places;
}

class GradedRows : public testing::TestWithParam<KinkedFace> {
protected:
  /// The step that the header's formula asks for.
  double wanted_step(double y) const {
    double step = std::min(grading.largest, grading.first + (grading.growth - 1.0) * (face.half_width - std::abs(y)));
    for (const double kink : face.kinks)
      step = std::min(step, grading.kink + (grading.growth - 1.0) * std::abs(y - kink));
    for (const RowPlace& end : face.contact_ends)
      step = std::min(step, end.step + (grading.growth - 1.0) * std::abs(y - end.y));
    return step;
  }

  /// Steps between two places, by Simpson's rule for the integral of 1/h.
  double steps_between(double from, double to) const {
    constexpr int parts = 200;
    double sum = 0.0;
    for (int n = 0; n <= parts; ++n) {
      const double weight = n == 0 || n == parts ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
      sum += weight / wanted_step(std::lerp(from, to, static_cast<double>(n) / parts));
    }
    return (to - from) * sum / (3.0 * parts);
  }

  /// The kinks, the ends and Y = 0, increasing.
  std::vector<double> places() const {
    std::vector<double> all = {-face.half_width, 0.0, face.half_width};
    all.insert(all.end(), face.kinks.begin(), face.kinks.end());
    std::ranges::sort(all);
    return all;
  }

  KinkedFace face = GetParam();
  RowGrading grading{.contact_ends = face.contact_ends};
  RowAxis rows = graded_rows(face.half_width, places_of(face.kinks, grading.kink), grading, Edge::ambient);
};

TEST_P(GradedRows, lie_in_every_kink_at_the_ends_and_in_the_middle) {
  EXPECT_EQ(rows.y(0), -face.half_width);
  EXPECT_EQ(rows.y(rows.count() - 1), face.half_width);
  EXPECT_EQ(rows.y(rows.central()), 0.0);
  for (const double kink : face.kinks) EXPECT_EQ(std::ranges::count(rows.y(), kink), 1) << kink;
  EXPECT_TRUE(rows.is_ambient(0));
  EXPECT_FALSE(rows.has_equal_steps());
}

// Between two places there are as many steps as the integral of 1/h says, rounded up, and all are the same part of it.
// The program's midpoint rule takes four parts to the shortest step, in which h grows by a tenth: half a percent.
TEST_P(GradedRows, share_out_the_steps_of_the_formula_evenly) {
  constexpr double allowed = 0.01;
  const std::vector<double> ends = places();
  int row = 0;
  for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
    double sum = 0.0, most = 0.0, least = HUGE_VAL;
    int steps = 0;
    for (; rows.y(row) < ends[n + 1]; ++row, ++steps) {
      const double part = steps_between(rows.y(row), rows.y(row + 1));
      sum += part;
      most = std::max(most, part);
      least = std::min(least, part);
    }
    EXPECT_EQ(steps, std::ceil(sum - allowed)) << ends[n];
    EXPECT_LT(most, 1.0 + allowed) << ends[n];
    EXPECT_NEAR(least, most, allowed) << ends[n];
  }
  EXPECT_EQ(row, rows.count() - 1);
}

INSTANTIATE_TEST_SUITE_P(of_faces, GradedRows, testing::ValuesIn(faces),
                         [](const auto& tested) { return std::string(tested.param.name); });

constexpr double half_width = 41.158;

TEST(SymmetricGradedRows, are_their_own_mirror_image_to_the_bit_and_half_of_them_the_upper_half) {
  for (const std::vector<double>& kinks : {std::vector<double>{}, {-23.519, 23.519}, {0.0}, {-40.0, -1.0, 1.0, 40.0}}) {
    for (const RowGrading& grading :
         {RowGrading{}, RowGrading{.first = 0.03}, RowGrading{.first = 0.5, .kink = 0.3, .growth = 2.0, .largest = 5.0},
          RowGrading{.contact_ends = {{-30.0, 0.4}, {30.0, 0.4}}, .reached = {-31.0, 31.0}}}) {
      const std::vector<RowPlace> places = places_of(kinks, grading.kink);
      const RowAxis all = graded_rows(half_width, places, grading, Edge::ambient),
                    half = graded_rows(half_width, places, grading, Edge::symmetry);
      ASSERT_EQ(all.count(), half.whole_count());
      for (int row = 0; row < all.count(); ++row) {
        EXPECT_EQ(all.y(row), -all.y(all.count() - 1 - row));
        EXPECT_EQ(all.y(row), half.whole_y(row));
      }
      EXPECT_TRUE(half.mirrored());
    }
  }
}

TEST(RowsBeyondContacts, are_as_far_apart_as_any) {
  const std::vector<RowPlace> kinks = places_of({-23.519, 23.519}, 0.1);
  const RowGrading grading{.reached = {-30.0, 10.0}};
  const RowAxis rows = graded_rows(half_width, kinks, grading, Edge::ambient);
  double before = -half_width, longest_between = 0.0;
  for (const double y : rows.y()) {
    if (before > 10.0) {
      EXPECT_GT(y - before, 0.8 * grading.largest) << y;  // counts are rounded up between two places
    }
    if (before < -23.519) longest_between = std::max(longest_between, y - before);
    before = y;
  }
  EXPECT_GT(longest_between, 0.9 * grading.largest);
  EXPECT_EQ(std::ranges::count(rows.y(), 23.519), 1);
}

TEST(RowGradingOf, longer_steps_has_fewer_rows) {
  RowGrading longer{.contact_ends = {{3.0, 0.7}}};
  longer.lengthen(2.0);
  EXPECT_DOUBLE_EQ(longer.contact_ends[0].step, 1.4);
  EXPECT_DOUBLE_EQ(longer.bend, 2.0 * RowGrading{}.bend);
  EXPECT_DOUBLE_EQ(longer.first, 2.0 * RowGrading{}.first);
  EXPECT_DOUBLE_EQ(longer.kink, 2.0 * RowGrading{}.kink);
  EXPECT_DOUBLE_EQ(longer.largest, 2.0 * RowGrading{}.largest);
  EXPECT_LT(graded_rows(half_width, {}, longer, Edge::ambient).count(),
            graded_rows(half_width, {}, {}, Edge::ambient).count());
}

}  // namespace
}  // namespace gearfilm

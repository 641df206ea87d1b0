// Fields carried to another grid of the same lattice, and grids that are widened.
#include "film/domain_margins.hpp"

#include "film_case.hpp"
#include "gearfilm/error.hpp"
#include "grid/remap.hpp"

namespace gearfilm {
namespace {

/// Zero at the inlet, the outlet and the side of `narrow`, like a pressure.
double bump(double x, double y) { return (x + 2.0) * (1.2 - x) * (1.5 - std::abs(y)) * (1.0 + 0.3 * x - 0.2 * y); }

class Remap : public testing::Test {
protected:
  static std::vector<double> on(const Grid& grid) {
    Field<double> field(grid);
    fill(grid, field, [](double x, double y) {
      const bool inside = x > -2.0 - 1e-9 && x < 1.2 + 1e-9 && y < 1.5 + 1e-9;
      return inside ? bump(x, y) : 0.0;
    });
    std::vector<double> compact(grid.local_size());
    field.store(compact);
    return compact;
  }

  const Grid narrow{PETSC_COMM_WORLD, rectangle(33, 31, -2.0, 1.2, 1.5)};
  // 3 lines before, 5 behind, 4 rows on either side; cut elsewhere among the processes.
  const Grid wide{PETSC_COMM_WORLD, rectangle(41, 39, -2.3, 1.7, 1.9)};
  static constexpr double round_off = 1e-12;
};

TEST_F(Remap, puts_a_pressure_where_it_was_and_zero_around) {
  ASSERT_TRUE(same_lattice(narrow.shape(), wide.shape()));
  const std::vector<double> moved = remapped(on(narrow), narrow, wide), expected = on(wide);
  ASSERT_EQ(moved.size(), expected.size());
  for (std::size_t n = 0; n < moved.size(); ++n) EXPECT_NEAR(moved[n], expected[n], round_off) << n;
}

TEST_F(Remap, and_back_is_the_same_to_the_bit) {
  const std::vector<double> field = on(narrow);
  EXPECT_EQ(remapped(remapped(field, narrow, wide), wide, narrow), field);
}

TEST_F(Remap, goes_on_beyond_the_edges_as_the_field_is_there) {
  Field<double> field(narrow);
  fill(narrow, field, [](double x, double y) { return 3.0 * x - 7.0 * y; });
  std::vector<double> compact(narrow.local_size());
  field.store(compact);
  const std::vector<double> moved = remapped(compact, narrow, wide);
  for (int i = 0; i < wide.nx(); ++i) {
    for (int j = 0; j < wide.y_count(); ++j) {
      const double x = std::clamp(wide.x(i), -2.0, 1.2), y = std::min(wide.y(j), 1.5);
      EXPECT_NEAR(moved[static_cast<std::size_t>(i) * wide.y_count() + j], 3.0 * x - 7.0 * y, round_off);
    }
  }
}

TEST_F(Remap, union_holds_both) {
  const GridShape longer = rectangle(36, 31, -2.3, 1.2, 1.5), broader = rectangle(38, 39, -2.0, 1.7, 1.9);
  const GridShape all = enclosing(longer, broader);
  EXPECT_EQ(all.nx, wide.nx());
  EXPECT_EQ(all.ny(), wide.ny());
  EXPECT_TRUE(same_lattice(all, wide.shape()));
  EXPECT_EQ(enclosing(all, narrow.shape()), all);
  EXPECT_EQ(enclosing(narrow.shape(), narrow.shape()), narrow.shape());
}

TEST_F(Remap, other_steps_or_places_are_another_lattice) {
  EXPECT_FALSE(same_lattice(narrow.shape(), rectangle(32, 31, -2.0, 1.2, 1.5)));
  EXPECT_FALSE(same_lattice(narrow.shape(), rectangle(33, 31, -2.05, 1.15, 1.5)));
  EXPECT_FALSE(same_lattice(narrow.shape(), rectangle(33, 33, -2.0, 1.2, 1.5)));
}

class MarginsOf : public testing::Test {
protected:
  DomainMargins needed(double load_ratio) const {
    return required_margins(rule, pitch.scales, {}, load_ratio * pitch.scales.static_force, "contact 3");
  }

  const FilmCase pitch = table3_pitch();
  const GridShape shape = pitch.shape(129, 65);
  MarginRule rule{.inlet = 0.5, .side = 1.06};
};

TEST_F(MarginsOf, grows_as_the_ellipse) {
  const double b = 1.0 / pitch.scales.hertz.ellipticity, growth = std::cbrt(1.7);
  EXPECT_NEAR(needed(1.7).side, 1.06 * growth * b, 1e-9);
  EXPECT_NEAR(needed(1.7).inlet, growth + 0.5, 1e-9);
  EXPECT_EQ(needed(0.0), DomainMargins());
  EXPECT_TRUE(fits(shape, needed(1.0)));
  EXPECT_FALSE(fits(shape, needed(1.3)));
}

TEST_F(MarginsOf, widened_grid_has_it_on_the_same_lattice) {
  for (const double ratio : {1.0, 1.15, 1.7, 3.0, 20.0}) {
    const GridShape wide = widened(shape, needed(ratio), rule);
    EXPECT_TRUE(fits(wide, needed(ratio))) << ratio;
    EXPECT_TRUE(same_lattice(shape, wide)) << ratio;
    EXPECT_EQ(enclosing(shape, wide), wide) << ratio;
    EXPECT_EQ((wide.nx - 1) % 16, 0) << ratio;  // 129 and 65 nodes can be halved; so can these
    EXPECT_EQ((wide.ny() - 1) % 8, 0) << ratio;
    if (ratio == 1.0) {
      EXPECT_EQ(wide, shape);
    }
  }
}

TEST_F(MarginsOf, ends_at_the_edges_of_the_teeth) {
  const double b = 1.0 / pitch.scales.hertz.ellipticity;
  rule.face = 1.15 * b;
  EXPECT_EQ(needed(1.5).side, rule.face);
  const GridShape wide = widened(shape, needed(1.5), rule);
  EXPECT_TRUE(fits(wide, needed(1.5)));
  EXPECT_LT(wide.row_axis.half_width(), rule.face + wide.row_axis.equal_step());
  try {
    needed(1.6);
    FAIL() << "the ellipse is longer than the face is wide";
  } catch (const SolveError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("contact 3: "), std::string::npos) << text;
    EXPECT_NE(text.find("edges of the teeth"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace gearfilm

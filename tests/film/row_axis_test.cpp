// Rows and what lies beyond them.
#include "grid/row_axis.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "film_case.hpp"

namespace gearfilm {
namespace {

TEST(RowAxisOf, half_a_domain_and_of_all_of_it_have_the_same_rows) {
  const RowAxis half = RowAxis::equal(33, 3.0), all = RowAxis::equal(33, 3.0, Edge::ambient);
  EXPECT_EQ(half.count(), 17);
  EXPECT_EQ(all.count(), 33);
  EXPECT_EQ(half.whole_count(), all.whole_count());
  for (int row = 0; row < 33; ++row) {
    EXPECT_EQ(half.whole_y(row), all.whole_y(row)) << row;
    EXPECT_EQ(all.y(row), -all.y(32 - row)) << row;
    EXPECT_EQ(half.y(half.stored_row(row)), std::abs(half.whole_y(row))) << row;
  }
  EXPECT_EQ(half.equal_step(), all.equal_step());
  EXPECT_EQ(half.half_width(), all.half_width());
  EXPECT_EQ(half.y(half.central()), 0.0);
  EXPECT_EQ(all.y(all.central()), 0.0);
  EXPECT_EQ(half.cells_outwards(), all.cells_outwards());
  EXPECT_EQ(half.inner({0, 17}).count(), 16);
  EXPECT_EQ(all.inner({0, 33}).count(), 31);
  EXPECT_FALSE(half.is_ambient(0));
  EXPECT_TRUE(all.is_ambient(0));
}

double width(const RowAxis& rows) {
  double sum = 0.0;
  for (int row = 0; row < rows.count(); ++row) sum += rows.is_ambient(row) ? 0.0 : rows.weight(row);
  return sum;
}

TEST(RowAxisOf, any_distances_gives_each_row_the_strip_nearest_to_it) {
  const RowAxis graded({-2.0, -1.5, 0.5, 1.0, 2.0}, Edge::ambient, Edge::ambient);
  EXPECT_DOUBLE_EQ(graded.weight(1), 1.25);
  EXPECT_DOUBLE_EQ(graded.step(1), 2.0);
  EXPECT_DOUBLE_EQ(width(graded), 4.0 - 0.25 - 0.5);
  EXPECT_EQ(graded.central(), 2);
  EXPECT_THROW((void)graded.equal_step(), std::logic_error);
  const RowAxis mirrored({0.0, 0.5, 2.0}, Edge::symmetry, Edge::ambient);
  EXPECT_DOUBLE_EQ(mirrored.weight(0), 0.5);
  EXPECT_DOUBLE_EQ(mirrored.weight(1), 2.0);
  EXPECT_DOUBLE_EQ(width(RowAxis::equal(9, 2.0)), width(RowAxis::equal(9, 2.0, Edge::ambient)));
}

TEST(RowAxisOf, equal_rows_is_coarsened_refined_and_extended_within_its_edges) {
  for (const Edge lower : {Edge::symmetry, Edge::ambient}) {
    const RowAxis rows = RowAxis::equal(33, 1.1, lower);
    ASSERT_TRUE(rows.can_coarsen());
    EXPECT_EQ(rows.coarsened(), RowAxis::equal(17, 1.1, lower));
    EXPECT_EQ(rows.coarsened().refined().whole_count(), 33);
    EXPECT_EQ(rows.with_whole_count(65), rows.refined());
    const RowAxis longer = rows.extended(3);
    EXPECT_EQ(longer.whole_count(), 39);
    EXPECT_TRUE(same_lattice(rows, longer));
    EXPECT_EQ(rows_between(longer, rows), lower == Edge::symmetry ? 0 : 3);
    EXPECT_EQ(enclosing(rows, longer), longer);
    EXPECT_EQ(enclosing(longer, rows), longer);
  }
  EXPECT_FALSE(RowAxis::equal(3, 1.0).can_coarsen());
  EXPECT_FALSE(same_lattice(RowAxis::equal(33, 1.1), RowAxis::equal(33, 1.1, Edge::ambient)));
}

TEST(RowAxisOf, rows_that_are_none_is_refused) {
  EXPECT_THROW(RowAxis({}, Edge::ambient, Edge::ambient), std::invalid_argument);
  EXPECT_THROW(RowAxis({0.0, 1.0, 1.0}, Edge::ambient, Edge::ambient), std::invalid_argument);
  EXPECT_THROW(RowAxis({0.5, 1.0}, Edge::symmetry, Edge::ambient), std::invalid_argument);
  EXPECT_THROW(RowAxis({-1.0, 0.0}, Edge::ambient, Edge::symmetry), std::invalid_argument);
}

// Two solutions to a residual of 1e-8.
TEST(WholeDomain, stationary_film_on_all_rows_is_that_on_half_of_them) {
  for (const auto& [film_case, nx, ny] : {std::tuple{table3_pitch(), 129, 65}, {circular_contact(), 65, 65}}) {
    const SolvedFilm half(PETSC_COMM_WORLD, film_case, nx, ny);
    const SolvedFilm all(PETSC_COMM_WORLD, film_case, nx, ny, {}, Edge::ambient);
    expect_whole_is_half(all.grid, whole_of(all.grid, all.film.total_pressure()), half.grid,
                         whole_of(half.grid, half.film.total_pressure()), 1e-6);
    expect_whole_is_half(all.grid, whole_of(all.grid, all.film.thickness()), half.grid,
                         whole_of(half.grid, half.film.thickness()), 1e-6);
    EXPECT_NEAR(all.result.solution.H0, half.result.solution.H0, 1e-6);
    EXPECT_NEAR(all.result.quantities.central_film, half.result.quantities.central_film, 1e-6);
    EXPECT_NEAR(all.result.quantities.smallest_film, half.result.quantities.smallest_film, 1e-6);
    report("%d x %d: %d and %d Newton iterations", nx, ny, all.result.counts.newton, half.result.counts.newton);
  }
}

}  // namespace
}  // namespace gearfilm

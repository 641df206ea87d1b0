// Line contacts, and what the ends of a face add to the deformation.
#include "elasticity/end_faces.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "elasticity/deformation.hpp"
#include "face_case.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

EndFaces free_ends(double poisson_ratio = 0.3) {
  return {.kind = EndFace::free, .bodies = {{.share = 1.0, .poisson_ratio = poisson_ratio}}};
}

// Hertz: P = (1 - X^2)^(1/2) with 2 pi C_h = 1 leaves a flat gap beneath X^2/2. Its constant is -1/pi times the
// integral of P ln|X|. Sampled with its root at the rim: off by a fifth of h^(3/2).
TEST(LineKernel, of_hertz_pressure_gives_a_parabola) {
  const Grid grid(PETSC_COMM_SELF, {513, -2.0, 2.0, RowAxis::line()});
  const Deformation<double> deformation(grid, 0.5 / pi);
  Field<double> pressure(grid), deformed(grid);
  fill(grid, pressure, [](double x, double) { return std::sqrt(std::max(0.0, 1.0 - x * x)); });
  deformation.apply(pressure, deformed);
  const double allowed = 0.2 * std::pow(grid.h_x(), 1.5);
  for (int i = 0; i < grid.nx(); ++i) {
    const double x = grid.x(i);
    if (std::abs(x) > 0.9) continue;
    EXPECT_NEAR(deformed.row(i)[0], 0.25 * (1.0 + 2.0 * std::numbers::ln2) - 0.5 * x * x, allowed) << x;
  }
}

// But for a constant that grows with the logarithm of its length; the rest is (X/length)^2.
TEST(LineKernel, is_that_of_a_long_strip) {
  constexpr double h_x = 0.1, half_length = 1e4;
  const auto strip = [](double x) { return love_kernel(x, h_x, {-half_length, half_length}); };
  for (const double x : {0.0, 0.1, 0.25, 3.0}) {
    EXPECT_NEAR(line_kernel(x, h_x) - line_kernel(1.0, h_x), strip(x) - strip(1.0), 1e-8) << x;
  }
}

/// Rows that stand close together at the lower end alone: at equal distances, then at growing ones, over a width.
RowAxis rows_from_one_end(int equal, double growth, double width) {
  std::vector<double> y;
  double step = 1.0;
  for (double at = 0.0; at < width; at += step) {
    y.push_back(at);
    if (static_cast<int>(y.size()) > equal) step *= growth;
  }
  const double middle = 0.5 * y.back();
  for (double& place : y) place -= middle;
  return {y, Edge::ambient, Edge::ambient};
}

double from_lower_end(const RowAxis& rows, int row) { return rows.y(row) - rows.y(0); }

/// The strip of a row, which ends with the face.
Strip strip_within(const RowAxis& rows, int row) {
  const Strip strip = rows.strip(row);
  return {std::max(strip.lower, rows.y(0)), std::min(strip.upper, rows.y(rows.count() - 1))};
}

double width_of(const RowAxis& rows, int row) {
  const Strip strip = strip_within(rows, row);
  return strip.upper - strip.lower;
}

/// Deformation at a row by the mirror image of a source row in the lower end.
double mirrored_kernel(const GridShape& shape, int lag, int row, int source) {
  const RowAxis& rows = shape.row_axis;
  const Strip strip = strip_within(rows, source);
  const double from = 2.0 * rows.y(0) - rows.y(row);
  return love_kernel(lag * shape.h_x(), shape.h_x(), {from - strip.upper, from - strip.lower});
}

// Flamant's wedge: far from a load P at the corner of a quarter plane the surface sinks by (c/pi) P ln s, c being
// (pi/2) ((1/2)/(pi/4 + 1/2) + (1/2)/(pi/4 - 1/2)) = 3.3630 times the half plane's, whatever Poisson's ratio.
// Lines are so wide that all is plane; loads over 16 cells know the corner to 1 %, the first cell's part being the
// largest.
TEST(FreeEnd, of_a_quarter_plane_sinks_like_flamants_wedge) {
  constexpr int loaded = 16;
  const double exact = 0.25 * pi * (1.0 / (0.25 * pi + 0.5) + 1.0 / (0.25 * pi - 0.5));
  const RowAxis rows = rows_from_one_end(24, 1.1, 1e5);
  const GridShape shape{5, -2e9, 2e9, rows};
  const auto row_at = [&](double distance) {
    int row = 0;
    while (from_lower_end(rows, row) < distance) ++row;
    return row;
  };
  const int near = row_at(10.0 * loaded), far = row_at(100.0 * loaded);
  std::vector<double> ratios;
  for (const double nu : {0.0, 0.3, 0.5}) {
    const EndFaceCompliance added(shape, free_ends(nu));
    double sunk = 0.0, load = 0.0;
    for (int source = 0; source < loaded; ++source) {
      const auto sinks = [&](int row) {
        const Strip strip = strip_within(rows, source);
        return added(0, row, source) +
               love_kernel(0.0, shape.h_x(), {strip.lower - rows.y(row), strip.upper - rows.y(row)});
      };
      sunk += sinks(near) - sinks(far);
      load += width_of(rows, source);
    }
    const double half_plane = 2.0 * load * std::log(from_lower_end(rows, far) / from_lower_end(rows, near));
    ratios.push_back(sunk / half_plane);
    report("Poisson's ratio %.1f: %.4f times the half plane's, exactly %.4f", nu, ratios.back(), exact);
    EXPECT_NEAR(ratios.back(), exact, 0.01 * exact) << nu;
    EXPECT_NEAR(ratios.back(), ratios.front(), 1e-6) << nu;
  }
}

// By how much the corner sinks more than on a half-space, over what a mirror image of the pressure would add: numbers
// of a program of its own, whose error is said to be 2 %, and these rows add a percent, for even pressure over |X| <= 1
// and a length from the end.
TEST(FreeEnd, sinks_beneath_short_loads_as_much_more_as_another_program_says) {
  constexpr int lines = 33, reach = 4;
  constexpr double h_x = 2.0 / (2 * reach + 1), length = 1.0, cell = length / 20.5;
  RowAxis rows = rows_from_one_end(21, 1.25, 1e4);
  std::vector<double> y = rows.y();
  for (double& place : y) place *= cell;
  rows = {y, Edge::ambient, Edge::ambient};
  const GridShape shape{lines, -0.5 * (lines - 1) * h_x, 0.5 * (lines - 1) * h_x, rows};
  const int middle = rows.central();  // so far away that only the motion as a whole is left
  for (const auto& [nu, expected] : {std::pair{0.0, 1.35}, {0.3, 1.73}, {0.5, 2.35}}) {
    const EndFaceCompliance added(shape, free_ends(nu));
    double more = 0.0, mirrored = 0.0;
    for (int lag = -reach; lag <= reach; ++lag) {
      for (int source = 0; from_lower_end(rows, source) < length; ++source) {
        more += added(std::abs(lag), 0, source) - added(std::abs(lag), middle, source);
        mirrored += mirrored_kernel(shape, lag, 0, source);
      }
    }
    report("Poisson's ratio %.1f: %.3f of a mirror image, expected %.2f", nu, more / mirrored, expected);
    EXPECT_NEAR(more / mirrored, expected, 0.03 * expected) << nu;
  }
}

// Betti: by a unit force here the surface sinks there as much as the other way round. Nothing in the equations enforces
// it; the mirror image, whose cells are no points, is left out. From a tenth of a to 5 a from the end the surface keeps
// it to 1 % of what the end adds; the very first row does not.
TEST(FreeEnd, sinks_there_by_a_force_here_as_here_by_a_force_there) {
  const RowAxis rows = graded_rows(41.158, {}, {.first = 0.03}, Edge::ambient);
  const GridShape shape{33, -8.0, 8.0, rows};
  for (const double nu : {0.3, 0.5}) {
    const EndFaceCompliance free(shape, free_ends(nu)), mirror(shape, {.kind = EndFace::mirror, .mirror_factor = 1.0});
    double worst = 0.0;
    int pairs = 0;
    for (const int lag : {0, 1, 8}) {
      const auto unmirrored = [&](int row, int source) {
        return (free(lag, row, source) - mirror(lag, row, source)) / width_of(rows, source);
      };
      for (int row = 0; from_lower_end(rows, row) < 5.0; ++row) {
        if (from_lower_end(rows, row) < 0.1) continue;
        for (int source = row + 1; from_lower_end(rows, source) < 5.0; ++source, ++pairs) {
          const double all =
              unmirrored(row, source) + mirrored_kernel(shape, lag, row, source) / width_of(rows, source);
          worst = std::max(worst, std::abs(unmirrored(row, source) - unmirrored(source, row)) / all);
        }
      }
    }
    report("Poisson's ratio %.1f: %d pairs of rows differ by up to %.2f %%", nu, pairs, 100.0 * worst);
    EXPECT_GT(pairs, 100);
    EXPECT_LT(worst, 0.015) << nu;  // of cells that are not centred on their nodes
  }
}

class EndFaceCompliances : public testing::Test {
protected:
  /// The largest difference of two, and the largest value of the first.
  std::pair<double, double> difference(const EndFaceCompliance& a, const EndFaceCompliance& b, double factor) const {
    double most = 0.0, top = 0.0;
    for (int lag = 0; lag < a.lags(); ++lag) {
      for (int row = 0; row < rows.count(); ++row) {
        for (int source = 0; source < rows.count(); ++source) {
          most = std::max(most, std::abs(a(lag, row, source) - factor * b(lag, row, source)));
          top = std::max(top, std::abs(a(lag, row, source)));
        }
      }
    }
    return {most, top};
  }

  RowAxis rows = graded_rows(12.0, {{-7.0, 0.1}, {7.0, 0.1}}, {.first = 0.2, .growth = 1.6}, Edge::ambient);
  GridShape shape{17, -3.0, 1.5, rows};
};

TEST_F(EndFaceCompliances, of_a_mirror_image_times_nothing_are_those_of_a_half_space) {
  const EndFaceCompliance none(shape, {.kind = EndFace::mirror, .mirror_factor = 0.0});
  EXPECT_EQ(difference(none, none, 1.0).second, 0.0);
  EXPECT_FALSE(EndFaces{}.act());
}

// But for a motion as a whole: compared with the middle row. Round-off of sums of a few units.
TEST_F(EndFaceCompliances, of_a_mirror_image_are_its_kernels_in_both_ends) {
  constexpr double factor = 1.39;
  const EndFaceCompliance mirror(shape, {.kind = EndFace::mirror, .mirror_factor = factor});
  const int middle = rows.central(), last = rows.count() - 1;
  for (const int lag : {0, 1, 16}) {
    const auto images = [&](int row, int source) {
      return mirrored_kernel(shape, lag, row, source) + mirrored_kernel(shape, lag, last - row, last - source);
    };
    for (int row = 0; row < rows.count(); ++row) {
      for (int source = 0; source < rows.count(); ++source) {
        EXPECT_NEAR(mirror(lag, row, source) - mirror(lag, middle, source),
                    factor * (images(row, source) - images(middle, source)), 1e-12);
      }
    }
  }
}

TEST_F(EndFaceCompliances, are_the_sum_of_those_of_the_bodies_that_end) {
  const EndFaceCompliance both(shape, free_ends()), one(shape, {EndFace::free, {{0.5, 0.3}}, 0.0}),
      alike(shape, {EndFace::free, {{0.6, 0.3}, {0.4, 0.3}}, 0.0}), other(shape, {EndFace::free, {{0.5, 0.45}}, 0.0}),
      unlike(shape, {EndFace::free, {{0.5, 0.3}, {0.5, 0.45}}, 0.0});
  const double top = difference(both, both, 1.0).second;
  EXPECT_GT(top, 0.1);
  EXPECT_LT(difference(both, one, 2.0).first, 1e-13 * top);
  EXPECT_LT(difference(both, alike, 1.0).first, 1e-13 * top);
  EXPECT_GT(difference(both, unlike, 1.0).first, 0.05 * top);
  double off = 0.0;
  for (int row = 0; row < rows.count(); ++row) {
    off = std::max(off, std::abs(unlike(0, row, 1) - one(0, row, 1) - other(0, row, 1)));
  }
  EXPECT_LT(off, 1e-13 * top);
}

// Beneath the half-ellipse of a line load, the same in all rows. Round-off of a sum of 30 thousand terms.
TEST_F(EndFaceCompliances, move_the_middle_of_the_face_no_nearer) {
  for (const EndFaces& ends : {free_ends(), EndFaces{.kind = EndFace::mirror, .mirror_factor = 1.39}}) {
    const EndFaceCompliance added(shape, ends);
    double mean = 0.0, top = 0.0;
    for (int row = 0; row < rows.count(); ++row) {
      double sum = 0.0;
      for (int i = -3; i <= 3; ++i) {
        const double x = i * shape.h_x();
        for (int source = 0; source < rows.count(); ++source) {
          sum += std::sqrt(1.0 - x * x) * added(std::abs(i), row, source);
        }
      }
      mean += width_of(rows, row) * sum;
      top = std::max(top, std::abs(width_of(rows, row) * sum));
    }
    EXPECT_LT(std::abs(mean), 1e-10 * top);
    EXPECT_GT(top, 0.1);
  }
}

// Rows at Y >= 0 know those at Y < 0 as mirror images; the other end of the face is one.
TEST_F(EndFaceCompliances, of_half_the_rows_are_those_of_all_of_them) {
  const RowAxis half = graded_rows(12.0, {{-7.0, 0.1}, {7.0, 0.1}}, {.first = 0.2, .growth = 1.6}, Edge::symmetry);
  ASSERT_EQ(half.whole_count(), rows.count());
  const int shift = half.count() - 1;
  for (const EndFaces& ends : {free_ends(), EndFaces{.kind = EndFace::mirror, .mirror_factor = 1.39}}) {
    const EndFaceCompliance all(shape, ends), of_half({shape.nx, shape.x_min, shape.x_max, half}, ends);
    for (int row = 0; row < half.count(); ++row) {
      for (int source = 0; source < half.count(); ++source) {
        const double image = source == 0 ? 0.0 : all(2, shift + row, shift - source);
        EXPECT_NEAR(of_half(2, row, source), all(2, shift + row, shift + source) + image, 1e-12);
      }
    }
  }
}

// The distributed convolution on unequal rows against the double sum, on half the rows and on all of them. Round-off of
// transforms of a few dozen points.
TEST(FaceDeformation, is_the_double_sum_of_the_half_space_and_what_the_ends_add) {
  constexpr double C_h = 0.37;
  for (const Edge lower : {Edge::symmetry, Edge::ambient}) {
    const RowAxis rows = graded_rows(12.0, {}, {.first = 0.3, .growth = 1.8}, lower);
    const Grid grid(PETSC_COMM_WORLD, {17, -3.0, 1.5, rows});
    const auto ends = std::make_shared<const EndFaceCompliance>(grid.shape(), free_ends());
    const Deformation<double> deformation(grid, C_h, ends);
    Field<double> pressure(grid), deformed(grid);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) pressure.row(i)[j] = noise(i, grid.y_begin() + j);
    }
    deformation.apply(pressure, deformed);
    double error = 0.0, top = 0.0, by_ends = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        const int row = grid.y_begin() + j;
        double sum = 0.0, added = 0.0;
        for (int k = 1; k < grid.nx() - 1; ++k) {
          for (int whole = 1; whole < rows.whole_count() - 1; ++whole) {
            const int stored = rows.stored_row(whole);
            const Strip strip = rows.strip(stored);
            const bool image = rows.whole_y(whole) != rows.y(stored);
            const double low = image ? -strip.upper : strip.lower, high = image ? -strip.lower : strip.upper;
            const double value = C_h * noise(k, stored);
            sum += value * love_kernel((i - k) * grid.h_x(), grid.h_x(), {low - rows.y(row), high - rows.y(row)});
            if (!image) added += value * (*ends)(std::abs(i - k), row, stored);
          }
        }
        error = std::max(error, std::abs(deformed.row(i)[j] - sum - added));
        top = std::max(top, std::abs(sum));
        by_ends = std::max(by_ends, std::abs(added));
      }
    }
    EXPECT_LT(maximum(error), 1e-13 * maximum(top));
    EXPECT_GT(maximum(by_ends), 0.1 * maximum(top));
  }
}

}  // namespace
}  // namespace gearfilm

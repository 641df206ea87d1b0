// Elastic deformation: the kernel, the distributed convolution, and Hertz' solution.
#include "elasticity/deformation.hpp"

#include <numbers>

#include "film_case.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

// Integral of 1/sqrt(x^2 + y^2) over a cell that does not contain the origin: 5-point Gauss rule on 64 x 64 panels.
// The nearest singularity, half a cell away, is 10 half-panels off or more in the cells tested: error 20^-10.
double quadrature(double x, double y, double h_x, double h_y) {
  constexpr double node[5] = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683, 0.906179845938664};
  constexpr double weight[5] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                0.236926885056189};
  constexpr int panels = 64;
  double sum = 0.0;
  for (int k = 0; k < 5 * panels; ++k) {
    const double s = x - 0.5 * h_x + h_x / panels * (k / 5 + 0.5 * (1.0 + node[k % 5]));
    for (int l = 0; l < 5 * panels; ++l) {
      const double t = y - 0.5 * h_y + h_y / panels * (l / 5 + 0.5 * (1.0 + node[l % 5]));
      sum += weight[k % 5] * weight[l % 5] / std::hypot(s, t);
    }
  }
  return 0.25 * h_x * h_y / (panels * panels) * sum;
}

TEST(LoveKernel, is_the_integral_over_a_distant_cell) {
  for (const double h_y : {0.1, 0.03, 0.4}) {
    for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {1, 1}, {5, 2}, {-3, 4}, {2, -7}}) {
      constexpr double h_x = 0.1;
      const double expected = quadrature(i * h_x, j * h_y, h_x, h_y);
      // Four corners of size (distance) cancel to (cell area)/(distance): round-off times (distance/cell)^2 ~ 1e3.
      EXPECT_NEAR(love_kernel(i * h_x, j * h_y, h_x, h_y), expected, 1e-12 * expected) << i << ' ' << j << ' ' << h_y;
    }
  }
}

// In polar coordinates the integral over the own cell is that of the distance to its rim over the angle.
TEST(LoveKernel, is_the_integral_over_the_own_cell) {
  for (const double h_y : {0.1, 0.03, 0.4}) {
    constexpr double h_x = 0.1;
    constexpr int steps = 2000;
    const double corner = std::atan2(h_y, h_x);
    double sum = 0.0;
    // Midpoint rule on either side of the corner, where the rim is smooth.
    for (int k = 0; k < steps; ++k) {
      const double middle = (k + 0.5) / steps;
      sum += corner / steps * 0.5 * h_x / std::cos(corner * middle);
      sum += (pi / 2 - corner) / steps * 0.5 * h_y / std::sin(corner + (pi / 2 - corner) * middle);
    }
    // The rule is off by (step)^2/24 times the change of slope, 1e-7 to 1e-6 of the value.
    EXPECT_NEAR(love_kernel(0.0, 0.0, h_x, h_y), 4.0 * sum, 2e-6 * 4.0 * sum) << h_y;
  }
}

TEST(LoveKernel, of_a_strip_is_the_sum_over_its_parts) {
  constexpr double h_x = 0.1, x = 0.3;
  const double whole = love_kernel(x, h_x, {-0.2, 0.7});
  EXPECT_NEAR(whole, love_kernel(x, h_x, {-0.2, 0.1}) + love_kernel(x, h_x, {0.1, 0.7}), 1e-14);
  EXPECT_NEAR(love_kernel(x, 0.25, h_x, 0.3), love_kernel(x, h_x, {0.1, 0.4}), 1e-15);
}

/// The strip of a row of the whole domain, half-way to the rows beside it.
Strip whole_strip(const RowAxis& rows, int row) {
  const double y = rows.whole_y(row);
  return {0.5 * (rows.whole_y(row - 1) + y), 0.5 * (y + rows.whole_y(row + 1))};
}

/// Rows that grow by a tenth from one to the next, away from the last one.
RowAxis graded_rows(int count, double first, Edge lower) {
  std::vector<double> y(count, first);
  double step = 0.03;
  for (int row = count - 1; row > 0; --row, step *= 1.1) y[row - 1] = y[row] - step;
  const double shift = first - y.front();
  for (double& place : y) place += shift;
  y.front() = first;
  return {y, lower, Edge::ambient};
}

template <class Real>
class DeformationOf : public testing::Test {
protected:
  // Round-off of a transform of a few hundred points, relative to the largest deformation.
  static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-13 : 1e-5;
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(DeformationOf, Precisions);

TYPED_TEST(DeformationOf, any_pressure_is_the_direct_double_sum_over_inner_nodes_of_the_whole_domain) {
  using Real = TypeParam;
  // Rows are summed over in those with up to 33, transformed in the others, of which rectangle(5, 97, ...) has fewer
  // wave numbers (6) than some processes would have rows. With two ambient edges the pressure is not symmetric. Unequal
  // rows are always summed over, 47 of them in blocks.
  for (const GridShape& shape :
       {rectangle(17, 11, -2.083, 1.25, 6.8), rectangle(24, 15, -4.5, 1.5, 3.0), rectangle(5, 33, -1.0, 1.0, 1.0),
        rectangle(9, 65, -2.0, 1.2, 1.1), rectangle(16, 97, -2.0, 1.2, 1.1), rectangle(5, 97, -1.0, 1.0, 1.0),
        rectangle(17, 12, -2.0, 1.2, 1.1, Edge::ambient), rectangle(16, 49, -2.0, 1.2, 1.1, Edge::ambient),
        GridShape{16, -2.0, 1.2, graded_rows(19, 0.0, Edge::symmetry)},
        GridShape{17, -2.0, 1.2, graded_rows(47, -2.0, Edge::ambient)}}) {
    const Grid grid(PETSC_COMM_WORLD, shape);
    constexpr double C_h = 0.37;
    const Deformation<Real> deformation(grid, C_h);
    Field<Real> pressure(grid), deformed(grid);
    pressure.fill(Real(1e6));  // ghosts must not matter
    deformed.fill(Real(-1.0));
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) pressure.row(i)[j] = static_cast<Real>(noise(i, grid.y_begin() + j));
    }
    deformation.apply(pressure, deformed);
    double error = 0.0, top = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      EXPECT_EQ(deformed.row(i)[-1], Real(-1.0));
      EXPECT_EQ(deformed.row(i)[grid.y_count()], Real(-1.0));
      for (int j = 0; j < grid.y_count(); ++j) {
        double sum = 0.0;
        for (int k = 1; k < grid.nx() - 1; ++k) {
          for (int row = 1; row < grid.ny() - 1; ++row) {
            const Strip strip = whole_strip(grid.row_axis(), row);
            sum += C_h *
                   love_kernel((i - k) * grid.h_x(), grid.h_x(), {strip.lower - grid.y(j), strip.upper - grid.y(j)}) *
                   static_cast<double>(static_cast<Real>(noise(k, grid.row_axis().stored_row(row))));
          }
        }
        error = std::max(error, std::abs(deformed.row(i)[j] - sum));
        top = std::max(top, std::abs(sum));
      }
    }
    EXPECT_LT(maximum(error), TestFixture::tolerance * maximum(top)) << shape.nx << " x " << shape.ny();
  }
}

TYPED_TEST(DeformationOf, several_fields_at_once_is_that_of_each) {
  using Real = TypeParam;
  for (const GridShape& shape : {rectangle(24, 15, -4.5, 1.5, 3.0), rectangle(16, 97, -2.0, 1.2, 1.1),
                                 rectangle(17, 12, -2.0, 1.2, 1.1, Edge::ambient),
                                 GridShape{16, -2.0, 1.2, graded_rows(19, 0.0, Edge::symmetry)},
                                 GridShape{17, -2.0, 1.2, graded_rows(47, -2.0, Edge::ambient)}}) {
    const Grid grid(PETSC_COMM_WORLD, shape);
    const Deformation<Real> deformation(grid, 0.37);
    constexpr int count = 3;  // a pair, and one that is left
    std::vector<Field<Real>> pressures(count, Field<Real>(grid)), together = pressures, alone = pressures;
    std::vector<const Field<Real>*> given;
    std::vector<Field<Real>*> sought;
    for (int n = 0; n < count; ++n) {
      pressures[n].fill(Real(1e6));  // ghosts must not matter
      together[n].fill(Real(-1.0));
      for (int i = 0; i < grid.nx(); ++i) {
        for (int j = 0; j < grid.y_count(); ++j) {
          pressures[n].row(i)[j] = static_cast<Real>(noise(i + 40 * n, grid.y_begin() + j));
        }
      }
      given.push_back(&pressures[n]);
      sought.push_back(&together[n]);
      deformation.apply(pressures[n], alone[n]);
    }
    deformation.apply(given, sought);
    for (int n = 0; n < count; ++n) {
      double difference = 0.0, top = 0.0;
      for (int i = 0; i < grid.nx(); ++i) {
        EXPECT_EQ(together[n].row(i)[-1], Real(-1.0));
        EXPECT_EQ(together[n].row(i)[grid.y_count()], Real(-1.0));
        for (int j = 0; j < grid.y_count(); ++j) {
          difference = std::max<double>(difference, std::abs(together[n].row(i)[j] - alone[n].row(i)[j]));
          top = std::max<double>(top, std::abs(alone[n].row(i)[j]));
        }
      }
      EXPECT_LT(maximum(difference), TestFixture::tolerance * maximum(top)) << shape.nx << " x " << shape.ny();
      EXPECT_GT(maximum(top), 0.0);
    }
  }
}

class HertzPressure : public testing::Test {
protected:
  HertzPressure() {
    hertz_pressure(grid, contact.scales, contact.scales.hertz, pressure);
    film.evaluate(pressure, 0.0);
  }

  // 257 x 129: the pressure's root at the rim of the ellipse costs h^(3/2), and must stay below 1e-4.
  FilmCase contact = table3_pitch();
  Grid grid{PETSC_COMM_WORLD, contact.shape(257, 129)};
  ContactFilm film{discretise(grid, contact.scales), contact.scales, MultigridOptions{}};
  std::vector<double> pressure = std::vector<double>(grid.local_size());
};

TEST_F(HertzPressure, deformation_flattens_hertz_pressure) {
  const double approach = contact.scales.approach;
  // The value that two independent programs give.
  EXPECT_NEAR(approach, 1.64956, 1e-5);
  double off = 0.0, sum = 0.0;
  int nodes = 0;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      if (std::hypot(grid.x(i), contact.scales.hertz.ellipticity * grid.y(j)) > 0.9) continue;
      off = std::max(off, std::abs(film.thickness().row(i)[j] - approach));
      sum += film.thickness().row(i)[j] - approach;
      ++nodes;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &nodes, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  report("gap inside 0.9 of the ellipse: largest deviation %.1e, mean %.1e", maximum(off), sum / nodes);
  EXPECT_LT(maximum(off), 1e-4);
  // The mean is the approach of the sampled pressure, whose load is 5e-5 too small at most.
  EXPECT_NEAR(sum / nodes, 0.0, 5e-5);
}

TEST_F(HertzPressure, carries_the_load) {
  // Sampled with its root at the rim: off by h^(3/2), 5e-5 of the load on this grid.
  const double load = contact.scales.static_force;
  EXPECT_DOUBLE_EQ(load, 2.0 * pi / (3.0 * contact.scales.hertz.ellipticity));
  EXPECT_NEAR(film.quantities(pressure, 0.0).pressure_integral, load, 1e-4 * load);
}

}  // namespace
}  // namespace gearfilm

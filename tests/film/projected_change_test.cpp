// Changes of the pressure that would leave some of it below zero.
#include "film/projected_change.hpp"

#include <cmath>

#include "film_case.hpp"

namespace gearfilm {
namespace {

/// A film that conducts alike everywhere, full where X < 0.2 + Y^2/4 with a pressure that grows as the square of the
/// distance from there, and a change by which the edge would draw back by a node or two.
template <class Real>
class ProjectedChange : public testing::Test {
protected:
  ProjectedChange() {
    for (int i = 1; i < grid.nx() - 1; ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        const double distance = 0.2 + 0.25 * grid.y(j) * grid.y(j) - grid.x(i);
        if (distance <= 0.0) continue;
        const std::size_t n = node(i, j);
        pressure[n] = distance * distance;
        change[n] = pressure[n] - (distance - edge) * (distance + edge);
        linear.by_pressure[centre].row(i)[j] = 4;
        for (const Neighbour side : {west, east, south, north}) linear.by_pressure[side].row(i)[j] = -1;
      }
    }
  }

  std::size_t node(int i, int j) const { return static_cast<std::size_t>(i) * grid.y_count() + j; }

  std::vector<double> projected(float weight) {
    std::vector<double> better = change;
    project_change<Real>(grid, linear, pressure, std::vector<float>(change.size(), weight), scratch, better);
    return better;
  }

  /// What the rows of nodes that stay full have beyond those of the given change.
  double rows_of(const std::vector<double>& changed) {
    Field<Real> difference(grid), rows(grid);
    const Field<Real> film(grid);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        difference.row(i)[j] = static_cast<Real>(changed[node(i, j)] - change[node(i, j)]);
      }
    }
    halo.exchange(difference);
    apply_stencil(linear, difference, film, rows);
    double sum = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        if (pressure[node(i, j)] > changed[node(i, j)]) sum += std::pow(rows.row(i)[j], 2);
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return std::sqrt(sum);
  }

  static constexpr double edge = 0.08;
  Grid grid{PETSC_COMM_WORLD, rectangle(41, 41, -1.0, 1.0, 1.0)};
  Halo halo{grid};
  FilmStencil<Real> linear{grid};
  Field<Real> scratch{grid};
  std::vector<double> pressure = std::vector<double>(grid.local_size()), change = pressure;
};

using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ProjectedChange, Precisions);

TYPED_TEST(ProjectedChange, leaves_nothing_below_zero_and_neighbours_better_balanced) {
  std::vector<double> clipped = this->change;
  for (std::size_t n = 0; n < clipped.size(); ++n) clipped[n] = std::min(clipped[n], this->pressure[n]);
  const std::vector<double> better = this->projected(0.01F);
  double lowest = 0.0;
  for (std::size_t n = 0; n < better.size(); ++n) lowest = std::min(lowest, this->pressure[n] - better[n]);
  EXPECT_GE(lowest, -1e-7);
  EXPECT_GT(this->rows_of(clipped), 0.01);
  EXPECT_LT(this->rows_of(better), 0.5 * this->rows_of(clipped));
}

TYPED_TEST(ProjectedChange, is_the_change_itself_where_oil_does_not_flow_freely_or_nothing_falls_dry) {
  EXPECT_EQ(this->projected(0.5F), this->change);
  for (double& value : this->change) value = -value;
  EXPECT_EQ(this->projected(0.01F), this->change);
}

}  // namespace
}  // namespace gearfilm

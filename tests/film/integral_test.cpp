// Integrals over the grid, common to all processes.
#include "grid/integral.hpp"

#include "film_case.hpp"

namespace gearfilm {
namespace {

TEST(Integral, is_the_sum_over_all_nodes_of_the_whole_domain_and_all_processes) {
  for (const GridShape& shape : {rectangle(17, 11, -2.0, 1.2, 1.0), rectangle(33, 17, -4.5, 1.5, 3.0),
                                 rectangle(17, 12, -2.0, 1.2, 1.0, Edge::ambient)}) {
    const Grid grid(PETSC_COMM_WORLD, shape);
    std::vector<double> values(grid.local_size());
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) values[i * grid.y_count() + j] = noise(i, grid.y_begin() + j);
    }
    double expected = 0.0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int row = 0; row < grid.ny(); ++row) expected += noise(i, grid.row_axis().stored_row(row));
    }
    EXPECT_NEAR(integral(grid, values), expected * grid.h_x() * grid.h_y(), 1e-12);
  }
}

}  // namespace
}  // namespace gearfilm

#include "grid/grid.hpp"

#include <algorithm>
#include <string>

#include "gearfilm/error.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

std::vector<int> even_ranges(MPI_Comm comm, const GridShape& shape) {
  const int processes = processes_in(comm);
  if (processes > shape.rows()) {
    throw InputError("grid with ny = " + std::to_string(shape.ny()) + " (" + std::to_string(shape.rows()) +
                     (shape.row_axis.mirrored() ? " rows with Y >= 0" : " rows") + ") cannot be cut among " +
                     std::to_string(processes) + " processes; use at most one process per row");
  }
  return cut_evenly(shape.rows(), processes);
}

// Beyond both edges there are ghosts too, which no neighbour fills.
OwnedDM create_nodes(MPI_Comm comm, const GridShape& shape, const std::vector<int>& y_ranges) {
  const auto processes = static_cast<PetscInt>(y_ranges.size()) - 1;
  std::vector<PetscInt> counts(processes);
  for (PetscInt p = 0; p < processes; ++p) counts[p] = y_ranges[p + 1] - y_ranges[p];
  const PetscInt all_x = shape.nx;
  OwnedDM nodes;
  petsc_check(DMDACreate2d(comm, DM_BOUNDARY_GHOSTED, DM_BOUNDARY_NONE, DMDA_STENCIL_STAR, shape.rows(), shape.nx,
                           processes, 1, 1, 1, counts.data(), &all_x, nodes.put()));
  petsc_check(DMSetUp(nodes));
  return nodes;
}

}  // namespace

std::vector<int> cut_evenly(int items, int processes) {
  std::vector<int> ranges(processes + 1);
  for (int p = 0; p <= processes; ++p) ranges[p] = static_cast<int>(static_cast<long>(items) * p / processes);
  return ranges;
}

GridShape rectangle(int nx, int ny, double x_min, double x_max, double y_half, Edge lower) {
  return {nx, x_min, x_max, RowAxis::equal(ny, y_half, lower)};
}

GridShape grid_shape(const Domain& domain, double ellipticity, int nx, int ny, Edge lower) {
  return rectangle(nx, ny, domain.x_min, domain.x_max, domain.y_half / ellipticity, lower);
}

Grid::Grid(MPI_Comm comm, const GridShape& shape) : Grid(comm, shape, even_ranges(comm, shape)) {}

Grid::Grid(MPI_Comm comm, const GridShape& shape, std::vector<int> y_ranges)
    : comm_(comm),
      rank_(rank_in(comm)),
      shape_(shape),
      h_x_(shape.h_x()),
      y_ranges_(std::move(y_ranges)),
      nodes_(std::make_shared<const OwnedDM>(create_nodes(comm, shape, y_ranges_))) {
  for (int j = 0; j < y_count(); ++j) row_weights_.push_back(row_axis().weight(y_begin() + j));
}

PetscInt Grid::vec_index(int i, int row) const {
  const auto owner = std::ranges::upper_bound(y_ranges_, row) - 1;
  const int begin = owner[0], count = owner[1] - owner[0];
  return static_cast<PetscInt>(nx()) * begin + i * count + row - begin;
}

OwnedVec Grid::create_vec() const {
  OwnedVec vec;
  petsc_check(DMCreateGlobalVector(nodes(), vec.put()));
  return vec;
}

bool Grid::can_coarsen(Coarsening along) const {
  const bool in_x = (nx() - 1) % 2 == 0 && (nx() - 1) / 2 + 1 >= 5;
  const bool in_y = row_axis().can_coarsen() || (along == Coarsening::both && keeps_rows());
  return (in_x || along == Coarsening::y_only) && (in_y || along == Coarsening::x_only);
}

int Grid::fewest_coarse_rows() const {
  int fewest = rows();
  for (int p = 0; p < processes(); ++p) fewest = std::min(fewest, (y_ranges_[p + 1] + 1) / 2 - (y_ranges_[p] + 1) / 2);
  return fewest;
}

Grid Grid::coarsened(Coarsening along) const {
  GridShape shape = shape_;
  std::vector<int> ranges(y_ranges_);
  if (along != Coarsening::y_only) shape.nx = (nx() - 1) / 2 + 1;
  if (along == Coarsening::y_only || (along == Coarsening::both && !keeps_rows())) {
    shape.row_axis = row_axis().coarsened();
    for (int& first : ranges) first = (first + 1) / 2;
  }
  return Grid(comm_, shape, std::move(ranges));
}

Grid Grid::gathered() const { return Grid(PETSC_COMM_SELF, shape_); }

}  // namespace gearfilm

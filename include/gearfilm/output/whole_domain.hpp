// Fields on all nodes of a domain, for output: grids store only those with Y >= 0.
#pragma once

#include "gearfilm/ehl/field.hpp"
#include "gearfilm/output/distributed_array.hpp"

namespace gearfilm {

/// The nodes (nx, ny) between -Y_half and Y_half, cut evenly in y among the processes.
class WholeDomain {
public:
  /// The grid must outlive the object.
  explicit WholeDomain(const Grid& grid);

  const Grid& grid() const { return grid_; }
  /// Y of a row, 0 <= row < ny.
  double y(int row) const { return grid_.h_y() * from_middle(row); }
  /// scale times a field of the grid, with its mirror image. Collective.
  DistributedArray unfold(const Field<double>& values, double scale) const;
  /// scale times X and Y of every node, as (nx, ny, 2).
  DistributedArray coordinates(double scale) const;

private:
  using OwnedScatter = PetscHandle<VecScatter, VecScatterDestroy>;

  /// Rows from the one at Y = 0 on, or before it.
  int from_middle(int row) const { return row - (grid_.rows() - 1); }
  int first_row() const { return cuts_[grid_.rank()]; }
  int end_row() const { return cuts_[grid_.rank() + 1]; }
  PetscInt index_on_grid(int i, int row) const;
  /// Of the nodes, without values.
  DistributedArray extents() const;

  const Grid& grid_;
  std::vector<int> cuts_;  ///< first row of every process, and their number
  OwnedVec stored_;
  OwnedVec whole_;
  OwnedScatter scatter_;
};

}  // namespace gearfilm

// Fields on all nodes of a domain, for output: mirrored rows are stored once (grid/row_axis.hpp).
#pragma once

#include "grid/field.hpp"
#include "grid/node_scatter.hpp"
#include "output/distributed_array.hpp"

namespace gearfilm {

/// The nodes (nx, ny) of the whole domain, cut evenly in y among the processes.
class WholeDomain {
public:
  /// The grid must outlive the object.
  explicit WholeDomain(const Grid& grid);

  const Grid& grid() const { return grid_; }
  /// Y of a row, 0 <= row < ny.
  double y(int row) const { return grid_.row_axis().whole_y(row); }
  /// scale times a field of the grid, on all rows. Collective.
  DistributedArray unfold(const Field<double>& values, double scale) const;
  /// scale times X and Y of every node, as (nx, ny, 2).
  DistributedArray coordinates(double scale) const;

private:
  int first_row() const { return cuts_[grid_.rank()]; }
  int end_row() const { return cuts_[grid_.rank() + 1]; }
  /// Where the grid's vectors have the nodes of the own rows.
  std::vector<PetscInt> sources() const;
  /// An array of the extents of all nodes, without values.
  DistributedArray extents() const;

  const Grid& grid_;
  std::vector<int> cuts_;  ///< first row of every process, and their number
  NodeScatter scatter_;
};

}  // namespace gearfilm

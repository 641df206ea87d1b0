// Uniform vertex-centred grid of one contact, cut in y among the processes.
//
// Nodes (i, j), i = 0..nx-1 from X_min to X_max, j = 0..rows-1 along the row axis; boundary nodes are included. A spur
// gear's film is its own mirror image in Y = 0, and only its rows with Y >= 0 are stored (row_axis.hpp).
// A process owns all x for a range of j, so that x-lines and x-transforms are local. In memory y is contiguous
// (index i*y_count + j): all x-lines are then processed together, with vector instructions across the lines.
//
// The cut is that of a PETSc DMDA whose first direction is y and whose second is x: its vectors are laid out like
// compact fields, its local vectors, with one ghost row on either side, like a Field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "grid/domain.hpp"
#include "grid/row_axis.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

/// Size and extent of the whole domain; lengths in units of the Hertz half-axis a in both directions.
struct GridShape {
  int nx = 0;
  double x_min = 0.0;
  double x_max = 0.0;
  RowAxis row_axis{};

  /// Rows of the whole domain, and those that are stored.
  int ny() const { return row_axis.whole_count(); }
  int rows() const { return row_axis.count(); }
  double h_x() const { return (x_max - x_min) / (nx - 1); }
  bool operator==(const GridShape&) const = default;
};

/// First item of every process, and their number, when items are cut as evenly as possible.
std::vector<int> cut_evenly(int items, int processes);

/// Equal steps from x_min to x_max and from -y_half to y_half, all lengths in units of a; with a lower edge of symmetry
/// ny is odd.
GridShape rectangle(int nx, int ny, double x_min, double x_max, double y_half, Edge lower = Edge::symmetry);
/// The grid of a domain whose y extent is given in units of b = a/ellipticity.
GridShape grid_shape(const Domain& domain, double ellipticity, int nx, int ny, Edge lower = Edge::symmetry);

/// In which directions only every second node is kept; graded rows, and a single one, are kept in `both`.
enum class Coarsening { both, x_only, y_only };

class Grid {
public:
  /// Cuts the rows evenly. Throws InputError when there are more processes than rows.
  Grid(MPI_Comm comm, const GridShape& shape);

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int processes() const { return static_cast<int>(y_ranges_.size()) - 1; }
  const GridShape& shape() const { return shape_; }
  int nx() const { return shape_.nx; }
  const RowAxis& row_axis() const { return shape_.row_axis; }
  /// Rows of the whole domain, and those that are stored.
  int ny() const { return shape_.ny(); }
  int rows() const { return shape_.rows(); }
  double h_x() const { return h_x_; }
  /// The step of equal rows.
  double h_y() const { return row_axis().equal_step(); }
  double x(int i) const { return shape_.x_min + h_x_ * i; }
  /// Y of the local row j (0 <= j < y_count).
  double y(int j) const { return row_axis().y(y_begin() + j); }
  int y_begin() const { return y_ranges_[rank_]; }
  int y_count() const { return y_ranges_[rank_ + 1] - y_ranges_[rank_]; }
  /// First row of every process, and their number.
  std::span<const int> y_ranges() const { return y_ranges_; }
  int local_size() const { return nx() * y_count(); }
  bool is_boundary(int i, int j) const { return i == 0 || i == nx() - 1 || row_axis().is_ambient(y_begin() + j); }
  /// The local rows in which P is an unknown.
  RowRange inner_rows() const {
    const RowRange inner = row_axis().inner({y_begin(), y_begin() + y_count()});
    return {inner.begin - y_begin(), inner.end - y_begin()};
  }
  /// Weights of the own rows in integrals over the whole domain [a] (RowAxis::weight).
  std::span<const double> row_weights() const { return row_weights_; }
  /// The local row in which fields are mirrored, or -1 where this process has none.
  int mirror_row() const { return local_row(row_axis().mirror_row()); }
  /// Local row of the global row, or -1 where another process owns it.
  int local_row(int global_row) const {
    return global_row >= y_begin() && global_row < y_begin() + y_count() ? global_row - y_begin() : -1;
  }

  /// The nodes as PETSc knows them; copies of a grid share it. -dm_view shows it when it is made.
  DM nodes() const { return *nodes_; }
  /// Where PETSc's vectors of the grid have the value of a node, whichever process owns it.
  PetscInt vec_index(int i, int row) const;
  /// A PETSc vector laid out like compact fields.
  OwnedVec create_vec() const;

  /// Whether rows are graded or single: coarser grids have all of them.
  bool keeps_rows() const { return !row_axis().has_equal_steps(); }
  /// True when every second node, those on the edges among them, is a grid of at least 5 x 3 nodes again.
  bool can_coarsen(Coarsening along = Coarsening::both) const;
  /// Rows that the process with the fewest would own on the coarsened grid.
  int fewest_coarse_rows() const;
  /// Every second node; a coarse row belongs to the process that owns the same fine row.
  Grid coarsened(Coarsening along = Coarsening::both) const;
  /// This grid, whole on every process.
  Grid gathered() const;

private:
  Grid(MPI_Comm comm, const GridShape& shape, std::vector<int> y_ranges);

  MPI_Comm comm_;
  int rank_ = 0;
  GridShape shape_;
  double h_x_;
  std::vector<int> y_ranges_;
  std::vector<double> row_weights_;
  std::shared_ptr<const OwnedDM> nodes_;
};

/// True of the slender contacts that gears have: twice as far across as along X to the next node, or farther. Lines
/// x = const. are few then, and the edge of the contact moves by many cells from one row to the next.
inline bool has_long_cells(const Grid& grid) { return grid.keeps_rows() || grid.h_y() >= 2.0 * grid.h_x(); }

/// Where equal cells are still longer, halving the rows loses what neighbouring rows differ in: coarser grids keep them
/// all.
inline bool needs_all_rows(const Grid& grid) { return !grid.keeps_rows() && grid.h_y() >= 8.0 * grid.h_x(); }

}  // namespace gearfilm

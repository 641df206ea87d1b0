// The rows of a grid, lines of nodes along X one behind another in Y, and what lies beyond the first and the last one.
//
// At an edge `symmetry` every field goes on as its mirror image in the edge's row. At an edge `ambient` the pressure is
// that of the surroundings, P = 0, in the edge's row and beyond it. Who needs a value beyond a row, the weight of a row
// in an integral over the whole domain, or the rows of the whole domain, asks here.
#pragma once

#include <optional>
#include <vector>

namespace gearfilm {

enum class Edge { symmetry, ambient };

/// Local or global rows from begin to end, without end.
struct RowRange {
  int begin = 0;
  int end = 0;

  int count() const { return end > begin ? end - begin : 0; }
};

/// A strip of the plane along X.
struct Strip {
  double lower = 0.0;  ///< Y of its edges [a]
  double upper = 0.0;
};

class RowAxis {
public:
  RowAxis() = default;
  /// Rows at increasing Y [a]. Rows whose distances agree to 1e-10 are equal ones. Throws std::invalid_argument where Y
  /// does not increase, where the upper edge is one of symmetry, or where a lower edge of symmetry is not at Y = 0.
  RowAxis(std::vector<double> y, Edge lower, Edge upper);
  /// Equal rows of a domain from -half_width to half_width [a] that has `whole` of them: with a lower edge of symmetry
  /// those at Y >= 0, and `whole` is odd.
  static RowAxis equal(int whole, double half_width, Edge lower = Edge::symmetry);
  /// The one row of a line contact, whose integrals are those by unit length.
  static RowAxis line();

  int count() const { return static_cast<int>(y_.size()); }
  double y(int row) const { return y_[row]; }
  const std::vector<double>& y() const { return y_; }
  Edge lower() const { return lower_; }
  Edge upper() const { return upper_; }
  bool mirrored() const { return lower_ == Edge::symmetry; }
  bool single() const { return count() == 1; }
  /// From a row to the next, for -1 <= row < count: beyond an edge as before it; of a single row its unit length.
  double step(int row) const;
  bool has_equal_steps() const { return equal_step_.has_value(); }
  /// The one distance between equal rows. Throws std::logic_error where they are not equal.
  double equal_step() const;
  bool operator==(const RowAxis&) const = default;

  /// The row in which fields are mirrored, or -1 where none is.
  int mirror_row() const { return mirrored() ? 0 : -1; }
  /// Whether P = 0 in this row.
  bool is_ambient(int row) const { return !single() && (row == count() - 1 || (row == 0 && !mirrored())); }
  /// The given rows in which P is an unknown.
  RowRange inner(RowRange rows) const;
  /// Rows from a row to the mirror image of another one, where there is an image.
  std::optional<int> distance_to_image(int row, int source) const;
  /// Width of the strips [a] for which a row stands in an integral over the whole domain, its mirror image included.
  double weight(int row) const;
  /// The strip around a row that reaches half-way to its neighbours, beyond an edge as far as before it.
  Strip strip(int row) const { return {y_[row] - 0.5 * step(row - 1), y_[row] + 0.5 * step(row)}; }
  /// The row nearest a place, and that nearest Y = 0.
  int nearest(double y) const;
  int central() const { return nearest(0.0); }
  /// Distance from Y = 0 to the nearer ambient edge.
  double half_width() const;

  /// Rows of the whole domain, the stored row at the place of one of them or of its mirror image, and its Y.
  int whole_count() const { return mirrored() && !y_.empty() ? 2 * count() - 1 : count(); }
  int stored_row(int whole_row) const;
  double whole_y(int whole_row) const;

  /// Whether rows are equal and every second one, the edges among them, are at least three of the whole domain.
  bool can_coarsen() const;
  RowAxis coarsened() const;
  /// Equal rows between the same edges: twice as close (others stay as they are), or so many in the whole domain.
  RowAxis refined() const;
  RowAxis with_whole_count(int whole) const;
  /// The axis with so many more rows of the same step at every ambient edge. Throws std::logic_error where rows are not
  /// equal.
  RowAxis extended(int more) const;
  /// How many steps there are between Y = 0 and an ambient edge, for equal rows.
  int cells_outwards() const { return whole_count() / 2; }

private:
  static RowAxis between(double first, double last, int count, Edge lower, Edge upper);

  std::vector<double> y_;
  Edge lower_ = Edge::symmetry;
  Edge upper_ = Edge::ambient;
  std::optional<double> equal_step_{};
};

/// Whether equal rows have the same step and edges, and lie at the same places where both axes have any; whether others
/// are the same.
bool same_lattice(const RowAxis& a, const RowAxis& b);
/// Rows from the first one of a to the first one of b, on one lattice.
int rows_between(const RowAxis& a, const RowAxis& b);
/// Rows that hold those of both, on one lattice; with two ambient edges as many more at either.
RowAxis enclosing(const RowAxis& a, const RowAxis& b);

}  // namespace gearfilm

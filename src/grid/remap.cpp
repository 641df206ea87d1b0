#include "gearfilm/grid/remap.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double same_place = 1e-6;  // in steps

/// Lines from the first of a to the first of b.
double lines_between(const GridShape& a, const GridShape& b) { return (b.x_min - a.x_min) / a.h_x(); }

/// The row of one grid that a row of another is taken from: beyond the first and the last one, that.
class SourceRow {
public:
  SourceRow(const Grid& from, const Grid& to)
      : shift_(rows_between(from.row_axis(), to.row_axis())), count_(from.rows()) {}

  int operator()(int row) const { return std::clamp(row + shift_, 0, count_ - 1); }
  RowRange operator()(RowRange rows) const {
    if (rows.count() == 0) return {};
    return {(*this)(rows.begin), (*this)(rows.end - 1) + 1};
  }

private:
  int shift_;
  int count_;
};

RowRange intersection(RowRange a, RowRange b) { return {std::max(a.begin, b.begin), std::min(a.end, b.end)}; }

RowRange rows_of(const Grid& grid, int process) { return {grid.y_ranges()[process], grid.y_ranges()[process + 1]}; }

/// How many values travel to, or from, every process, and where they begin.
struct Traffic {
  std::vector<int> counts, offsets;

  void add(int count) {
    offsets.push_back(offsets.empty() ? 0 : offsets.back() + counts.back());
    counts.push_back(count);
  }
  std::size_t total() const { return static_cast<std::size_t>(offsets.back()) + counts.back(); }
};

}  // namespace

bool same_lattice(const GridShape& a, const GridShape& b) {
  const auto equal = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
  const double lines = lines_between(a, b);
  return equal(a.h_x(), b.h_x()) && same_lattice(a.row_axis, b.row_axis) &&
         std::abs(lines - std::round(lines)) < same_place;
}

GridShape enclosing(const GridShape& a, const GridShape& b) {
  GridShape all = a;
  const int before = std::max(0, -static_cast<int>(std::lround(lines_between(a, b))));
  const int after = std::max(0, static_cast<int>(std::lround((b.x_max - a.x_max) / a.h_x())));
  all.nx += before + after;
  if (before > 0) all.x_min = b.x_min;
  if (after > 0) all.x_max = b.x_max;
  all.row_axis = enclosing(a.row_axis, b.row_axis);
  return all;
}

std::vector<double> remapped(std::span<const double> field, const Grid& from, const Grid& to) {
  const SourceRow source_row(from, to);
  const RowRange own_from = rows_of(from, from.rank()), own_to = rows_of(to, to.rank());
  const RowRange wanted = source_row(own_to);
  const int lines = from.nx();
  Traffic sent, received;
  std::vector<double> out;
  for (int p = 0; p < to.processes(); ++p) {
    const RowRange rows = intersection(own_from, source_row(rows_of(to, p)));
    sent.add(lines * rows.count());
    received.add(lines * intersection(wanted, rows_of(from, p)).count());
    for (int i = 0; rows.count() > 0 && i < lines; ++i) {
      const auto line = field.begin() + static_cast<std::ptrdiff_t>(i) * own_from.count() - own_from.begin;
      out.insert(out.end(), line + rows.begin, line + rows.end);
    }
  }
  std::vector<double> in(received.total());
  MPI_Alltoallv(out.data(), sent.counts.data(), sent.offsets.data(), MPI_DOUBLE, in.data(), received.counts.data(),
                received.offsets.data(), MPI_DOUBLE, to.comm());

  std::vector<double> result(to.local_size());
  const int shift = static_cast<int>(std::lround(lines_between(from.shape(), to.shape())));
  for (int p = 0; p < from.processes(); ++p) {
    const RowRange rows = intersection(wanted, rows_of(from, p));
    if (rows.count() == 0) continue;
    for (int i = 0; i < to.nx(); ++i) {
      const int line = std::clamp(i + shift, 0, lines - 1);
      const double* source = in.data() + received.offsets[p] + static_cast<std::size_t>(line) * rows.count();
      double* target = result.data() + static_cast<std::size_t>(i) * own_to.count();
      for (int row = own_to.begin; row < own_to.end; ++row) {
        const int taken = source_row(row);
        if (taken >= rows.begin && taken < rows.end) target[row - own_to.begin] = source[taken - rows.begin];
      }
    }
  }
  return result;
}

}  // namespace gearfilm

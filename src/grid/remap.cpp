#include "grid/remap.hpp"

#include <algorithm>
#include <cmath>

#include "grid/node_scatter.hpp"

namespace gearfilm {
namespace {

constexpr double same_place = 1e-6;  // in steps

/// Lines from the first of a to the first of b.
double lines_between(const GridShape& a, const GridShape& b) { return (b.x_min - a.x_min) / a.h_x(); }

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
  const int lines = static_cast<int>(std::lround(lines_between(from.shape(), to.shape())));
  const int rows = rows_between(from.row_axis(), to.row_axis());
  const auto nearest = [](int place, int count) { return std::clamp(place, 0, count - 1); };
  std::vector<PetscInt> sources;
  for (int i = 0; i < to.nx(); ++i) {
    for (int row = to.y_begin() + rows; row < to.y_begin() + to.y_count() + rows; ++row) {
      sources.push_back(from.vec_index(nearest(i + lines, from.nx()), nearest(row, from.rows())));
    }
  }
  std::vector<double> result(sources.size());
  NodeScatter(from, sources)(field, result);
  return result;
}

}  // namespace gearfilm

#include "film/face_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

/// Half-width s [a] of a row as a line contact under the load w by unit length [p_h a]: s^2 = 4 C_h Rbar w.
double line_half_width(const Scales& scales, const ContactConditions& conditions, double load) {
  return std::sqrt(4.0 * scales.C_h * conditions.dry_radius() * load);
}

/// Fills the pressures [p_h] of a grid: a semi-ellipse about X = centre [a] in each row, with its load by unit length
/// [p_h a] and its half-width [a].
void semi_ellipses(const Grid& grid, double centre, const std::vector<double>& loads, const std::vector<double>& widths,
                   std::span<double> pressure) {
  for (int j = 0; j < grid.y_count(); ++j) {
    const int row = grid.y_begin() + j;
    const double s = widths[row], top = 2.0 * loads[row] / (std::numbers::pi * s);
    for (int i = 0; i < grid.nx(); ++i) {
      const double x = (grid.x(i) - centre) / s, inside = 1.0 - x * x;
      const bool loaded = inside > 0.0 && !grid.is_boundary(i, j);
      pressure[static_cast<std::size_t>(i) * grid.y_count() + j] = loaded ? top * std::sqrt(inside) : 0.0;
    }
  }
}

}  // namespace

double largest_half_width(const Scales& scales, const ContactConditions& conditions, double pressure_integral) {
  if (scales.solids.line) return line_half_width(scales, conditions, pressure_integral);
  return scales.face_law->at_force(pressure_integral, conditions.dry_radius()).half_width;
}

double face_pressure(Discretisation& discretisation, const Scales& scales, const ContactConditions& conditions,
                     double pressure_integral, std::span<double> pressure) {
  std::vector<double> loads = {pressure_integral}, widths = {line_half_width(scales, conditions, pressure_integral)};
  double approach = 0.0;
  if (!scales.solids.line) {
    RowContact& rows = discretisation.prepare_row_contact(scales);
    approach = rows.solve(pressure_integral, conditions.dry_radius()).approach;
    loads = rows.loads();
    widths = rows.half_widths();
  }
  semi_ellipses(discretisation.grid(), conditions.nearest.X, loads, widths, pressure);
  return approach;
}

std::vector<double> rescaled_face_pressure(Discretisation& discretisation, const Scales& scales,
                                           const ContactConditions& conditions, double before, double after,
                                           std::span<const double> pressure) {
  constexpr double settled = 1e-4;
  constexpr double narrowest = 0.05;  // half-width whose pressure tells what it would be on a wider row [a]
  const Grid& grid = discretisation.grid();
  RowContact& rows = discretisation.prepare_row_contact(scales);
  rows.solve(before, conditions.dry_radius(), settled);
  const std::vector<double> widths = rows.half_widths();
  rows.solve(after, conditions.dry_radius(), settled);
  std::vector<double> values(pressure.size());
  const double centre = conditions.nearest.X;
  semi_ellipses(grid, centre, rows.loads(), rows.half_widths(), values);
  for (int j = 0; j < grid.y_count(); ++j) {
    const int row = grid.y_begin() + j;
    if (widths[row] < narrowest) continue;
    const double ratio = std::max(rows.half_widths()[row], 0.1 * widths[row]) / widths[row];
    double load = 0.0, rescaled = 0.0;  // by unit length, in steps of the grid
    for (int i = 1; i < grid.nx() - 1; ++i) {
      const double place =
          std::clamp((centre + (grid.x(i) - centre) / ratio - grid.x(0)) / grid.h_x(), 0.0, grid.nx() - 1.001);
      const auto n = static_cast<std::size_t>(place);
      const auto at = [&](std::size_t line) { return pressure[line * grid.y_count() + j]; };
      double& value = values[static_cast<std::size_t>(i) * grid.y_count() + j];
      value = ratio * std::lerp(at(n), at(n + 1), place - static_cast<double>(n));
      load += at(static_cast<std::size_t>(i));
      rescaled += value;
    }
    // Lines between nodes have less of it.
    for (int i = 1; i < grid.nx() - 1 && rescaled > 0.0; ++i) {
      values[static_cast<std::size_t>(i) * grid.y_count() + j] *= ratio * ratio * load / rescaled;
    }
  }
  return values;
}

}  // namespace gearfilm

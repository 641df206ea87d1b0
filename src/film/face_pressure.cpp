#include "film/face_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

constexpr double share_of_penetration = 0.45;  // of s^2: the rest is what the whole face gives way together

/// 2 pi C_h Rbar
double compliance_of(const Scales& scales, const ContactConditions& conditions) {
  return 2.0 * std::numbers::pi * scales.C_h * conditions.dry_radius();
}

}  // namespace

std::vector<double> face_gaps(const RowAxis& rows, const Scales& scales) {
  std::vector<double> gaps;
  for (const double y : rows.y()) {
    const double lead = scales.solids.face ? (*scales.solids.face)(y * scales.length) / scales.thickness : 0.0;
    gaps.push_back(0.5 * scales.radius_ratio * y * y + lead);
  }
  return gaps;
}

std::vector<double> row_half_widths(const RowAxis& rows, const Scales& scales, const ContactConditions& conditions,
                                    double pressure_integral) {
  const std::vector<double> gaps = face_gaps(rows, scales);
  const double k = 1.0 / compliance_of(scales, conditions);
  std::vector<double> squares(gaps.size());
  const auto load_at = [&](double c) {
    double load = 0.0;
    for (int row = 0; row < rows.count(); ++row) {
      squares[row] = share_of_penetration * conditions.dry_radius() * std::max(0.0, c - gaps[row]);
      if (!rows.is_ambient(row)) load += 0.5 * std::numbers::pi * k * squares[row] * rows.weight(row);
    }
    return load;
  };
  double low = *std::ranges::min_element(gaps), high = low + 1.0;
  while (load_at(high) < pressure_integral) high = low + 2.0 * (high - low);
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (load_at(middle) < pressure_integral ? low : high) = middle;
  }
  load_at(high);
  std::ranges::transform(squares, squares.begin(), [](double square) { return std::sqrt(square); });
  return squares;
}

double largest_half_width(const Scales& scales, const ContactConditions& conditions, double pressure_integral) {
  if (scales.face_law) return scales.face_law->at_force(pressure_integral, conditions.dry_radius()).half_width;
  constexpr int places = 65;
  const RowAxis rows = scales.solids.line ? RowAxis::line()
                                          : RowAxis::equal(places, 0.5 * scales.solids.face->width / scales.length,
                                                           Edge::ambient);
  return std::ranges::max(row_half_widths(rows, scales, conditions, pressure_integral));
}

void face_pressure(const Grid& grid, const Scales& scales, const ContactConditions& conditions,
                   double pressure_integral, std::span<double> pressure) {
  const std::vector<double> widths = row_half_widths(grid.row_axis(), scales, conditions, pressure_integral);
  const double k = 1.0 / compliance_of(scales, conditions);
  for (int i = 0; i < grid.nx(); ++i) {
    const double x = grid.x(i) - conditions.nearest.X;
    for (int j = 0; j < grid.y_count(); ++j) {
      const double s = widths[grid.y_begin() + j], square = s * s - x * x;
      const bool loaded = square > 0.0 && !grid.is_boundary(i, j);
      pressure[static_cast<std::size_t>(i) * grid.y_count() + j] = loaded ? k * std::sqrt(square) : 0.0;
    }
  }
}

}  // namespace gearfilm

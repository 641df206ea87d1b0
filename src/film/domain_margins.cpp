#include "film/domain_margins.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "contact/line_contact.hpp"
#include "film/face_pressure.hpp"
#include "gearfilm/error.hpp"
#include "grid/domain.hpp"

namespace gearfilm {
namespace {

constexpr double outlet = 1.06;   // least distance, of the ellipse's half-axis: oil cavitates before
constexpr double in_spare = 1.1;  // of that, where a domain is widened

/// The largest power of two that divides a number of cells, but no more than an eighth of them.
int block_of(int cells) {
  int block = 1;
  while (cells % (2 * block) == 0 && 16 * block <= cells) block *= 2;
  return block;
}

/// Cells to add, in whole blocks, so that an edge at `present` comes to `wanted`.
int cells_to(double present, double wanted, double step, int block) {
  if (wanted <= present) return 0;
  return block * static_cast<int>(std::ceil((wanted - present) / (block * step) - 1e-9));
}

}  // namespace

DomainMargins required_margins(const MarginRule& rule, const Scales& scales, const ContactConditions& conditions,
                               double pressure_integral, const std::string& where, double growth) {
  if (pressure_integral <= 0.0) return {};
  const double reach = asperity_reach(scales), inlet = std::max(rule.inlet, reach);
  if (!has_ellipse(scales.solids)) {
    const double a = largest_half_width(scales, conditions, pressure_integral);
    return {.inlet = growth * a + inlet - conditions.nearest.X,
            .outlet = outlet * growth * a + reach + conditions.nearest.X,
            .side = 0.0};
  }
  const HertzContact ellipse = dry_contact(scales, conditions, pressure_integral);
  const double a = ellipse.a / scales.length, b = ellipse.b / scales.length;
  if (b > rule.face) {
    std::ostringstream message;
    message << where << ": the Hertz ellipse under " << pressure_integral / scales.static_force
            << " times the static load is " << 2e3 * ellipse.b << " mm long, and the face is "
            << 2e3 * rule.face * scales.length
            << " mm wide: the load reaches the edges of the teeth; set grid.whole_face to yes for films over the whole "
               "face, "
               "or raise crowning or face width";
    throw EdgesReached(message.str());
  }
  return {.inlet = growth * a + inlet - conditions.nearest.X,
          .outlet = outlet * growth * a + reach + conditions.nearest.X,
          .side = std::min((rule.side * growth + reach) * b, rule.face)};
}

DomainMargins enclosing(const DomainMargins& a, const DomainMargins& b) {
  return {std::max(a.inlet, b.inlet), std::max(a.outlet, b.outlet), std::max(a.side, b.side)};
}

bool fits(const GridShape& shape, const DomainMargins& needed) {
  return needed.inlet <= -shape.x_min && needed.outlet <= shape.x_max && needed.side <= shape.row_axis.half_width();
}

GridShape widened(const GridShape& shape, const DomainMargins& needed, const MarginRule& rule) {
  const RowAxis& rows = shape.row_axis;
  const double h_x = shape.h_x(), half_width = rows.half_width();
  const int block_x = block_of(shape.nx - 1);
  const auto spared = [](double present, double wanted) { return wanted > present ? in_spare * wanted : present; };
  GridShape wide = shape;
  const int before = cells_to(-shape.x_min, spared(-shape.x_min, needed.inlet), h_x, block_x);
  const int after = cells_to(shape.x_max, spared(shape.x_max, needed.outlet), h_x, block_x);
  wide.nx += before + after;
  wide.x_min -= before * h_x;
  wide.x_max += after * h_x;
  if (needed.side <= half_width) return wide;
  const double h_y = rows.equal_step();
  // Beyond the face there is no tooth: less than a block serves there.
  int across = cells_to(half_width, spared(half_width, needed.side), h_y, block_of(rows.cells_outwards()));
  while (across > 0 && half_width + (across - 1) * h_y >= rule.face) --across;
  if (across > 0) wide.row_axis = rows.extended(across);
  return wide;
}

}  // namespace gearfilm

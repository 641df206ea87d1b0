// The dry pressure along a whole face as a guess, row by row: each row is a line contact of the half-width s,
//   P(X) = (s^2 - X^2)^(1/2)/(2 pi C_h Rbar) ,   s^2 = 0.45 Rbar (c - l(Y) - D Y^2/2)_+
// with the penetration c that carries the load. It is no solution: rows do not deform each other here.
#pragma once

#include <span>
#include <vector>

#include "film/contact_conditions.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// Gap along the face of the rows of an axis, crowning included [-].
std::vector<double> face_gaps(const RowAxis& rows, const Scales& scales);

/// Half-widths s of the rows under a pressure integral.
std::vector<double> row_half_widths(const RowAxis& rows, const Scales& scales, const ContactConditions& conditions,
                                    double pressure_integral);

/// The largest of them anywhere on the face; of a line contact its half-width.
double largest_half_width(const Scales& scales, const ContactConditions& conditions, double pressure_integral);

/// The pressure on the own nodes, zero on the boundary; compact.
void face_pressure(const Grid& grid, const Scales& scales, const ContactConditions& conditions,
                   double pressure_integral, std::span<double> pressure);

}  // namespace gearfilm

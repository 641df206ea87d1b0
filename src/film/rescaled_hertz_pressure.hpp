// The pressure of a contact whose ellipse has become smaller or larger, from that before.
//
// In a Hertz contact the pressure on each line Y = const. is P = p_h sqrt(q - X^2/a^2), q = 1 - Y^2/b^2: when all
// half-axes change by a ratio r, a line's width and its pressures change by s = sqrt((r^2 - Y^2/b^2)/q), so that
//   P'(X, Y) = s P(X/s, Y)
// A film keeps to that but for its inlet and its exit. Lines are treated one by one: nothing travels between processes.
#pragma once

#include <span>
#include <vector>

#include "contact/scales.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// Compact pressures of the contact about X = centre after its ellipse has changed by the ratio of half-axes. Lines
/// that were loaded and are no longer keep a tenth.
std::vector<double> rescaled_hertz_pressure(const Grid& grid, const Scales& scales, const HertzContact& before,
                                            double ratio, std::span<const double> pressure, double centre = 0.0);

}  // namespace gearfilm

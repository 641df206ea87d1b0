// Deformation of a half-space by unit pressure on a rectangle, without C_h (Love 1929, doi 10.1098/rsta.1929.0009):
// with X and Y from the place where it is looked for, differences over the rectangle's corners of
//   X asinh(Y/|X|) + Y asinh(X/|Y|)
// and by unit pressure on an endless strip across X, where that is measured from infinity, but for a constant:
//   -2 (X ln|X| - X)
#pragma once

#include <cmath>

#include "grid/row_axis.hpp"
#include "lubricant/vector_math.hpp"

namespace gearfilm {

inline double love_corner(double x, double y) {
  const double sum = x * asinh(y / std::abs(x)) + y * asinh(x / std::abs(y));
  return y == 0.0 ? 0.0 : sum;
}

/// Deformation at distance x from the middle line of a cell h_x wide that lies in a strip of Y relative to the place.
inline double love_kernel(double x, double h_x, const Strip& strip) {
  const double x_low = x - 0.5 * h_x, x_high = x + 0.5 * h_x;
  return love_corner(x_high, strip.upper) - love_corner(x_low, strip.upper) - love_corner(x_high, strip.lower) +
         love_corner(x_low, strip.lower);
}

/// Deformation at distance (x, y) from the centre of a cell h_x by h_y.
inline double love_kernel(double x, double y, double h_x, double h_y) {
  return love_kernel(x, h_x, {y - 0.5 * h_y, y + 0.5 * h_y});
}

/// Deformation at distance x from the middle line of an endless strip h_x wide.
inline double line_kernel(double x, double h_x) {
  const auto edge = [](double at) { return at * std::log(std::abs(at)) - at; };
  return -2.0 * (edge(x + 0.5 * h_x) - edge(x - 0.5 * h_x));
}

}  // namespace gearfilm

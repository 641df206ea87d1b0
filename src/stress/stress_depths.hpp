// Depths at which stresses are computed, and where between them a largest value lies.
//
//   z_k = z_max (k/(n - 1))^1.5 ,  k = 0..n-1
// More of them lie beneath the surface, where friction acts. Between depths a maximum is that of the parabola through
// three of them: its value to 1e-3, its depth to 0.02 a with 24 depths down to 2 a.
#pragma once

#include <span>
#include <vector>

namespace gearfilm {

std::vector<double> stress_depths(double deepest, int count);

/// A largest value and where it is.
struct Peak {
  double value = 0.0;
  double at = 0.0;
};

/// The largest of values at increasing places, at `from` or beyond. Throws std::invalid_argument where there is none.
Peak largest_between(std::span<const double> places, std::span<const double> values, double from = 0.0);

}  // namespace gearfilm

// The integral of a smooth function of which samples are known, at any places: in each interval that of the cubic
// through its ends and a neighbour on either side, at the ends of the stretch through the four nearest; of fewer than
// four samples of the polynomial through all. Exact for cubics.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace gearfilm {

inline double sampled_integral(std::span<const double> places, std::span<const double> values) {
  const std::size_t count = places.size(), nodes = std::min<std::size_t>(4, count);
  const auto interpolated = [&](std::size_t first, double at) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + nodes; ++i) {
      double weight = values[i];
      for (std::size_t j = first; j < first + nodes; ++j) {
        if (j != i) weight *= (at - places[j]) / (places[i] - places[j]);
      }
      sum += weight;
    }
    return sum;
  };
  double integral = 0.0;
  for (std::size_t n = 0; n + 1 < count; ++n) {
    const std::size_t first = std::min(n == 0 ? 0 : n - 1, count - nodes);
    const double half = 0.5 * (places[n + 1] - places[n]), middle = 0.5 * (places[n + 1] + places[n]);
    const double gauss = half / std::sqrt(3.0);
    integral += half * (interpolated(first, middle - gauss) + interpolated(first, middle + gauss));
  }
  return integral;
}

}  // namespace gearfilm

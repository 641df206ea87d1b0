#include "stress/stress_depths.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gearfilm {

std::vector<double> stress_depths(double deepest, int count) {
  std::vector<double> depths(count);
  for (int k = 0; k < count; ++k) depths[k] = deepest * std::pow(static_cast<double>(k) / (count - 1), 1.5);
  return depths;
}

Peak largest_between(std::span<const double> places, std::span<const double> values, double from) {
  const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(places, from) - places.begin());
  if (begin == places.size()) throw std::invalid_argument("no depth lies so deep");
  const auto k = static_cast<std::size_t>(std::ranges::max_element(values.subspan(begin)) - values.begin());
  if (k == begin || k + 1 == values.size()) return {values[k], places[k]};
  // Newton's form of the parabola.
  const double left = (values[k] - values[k - 1]) / (places[k] - places[k - 1]),
               right = (values[k + 1] - values[k]) / (places[k + 1] - places[k]),
               bend = (right - left) / (places[k + 1] - places[k - 1]);
  if (!(bend < 0.0)) return {values[k], places[k]};
  const double at = 0.5 * (places[k - 1] + places[k] - left / bend);
  return {values[k - 1] + left * (at - places[k - 1]) + bend * (at - places[k - 1]) * (at - places[k]), at};
}

}  // namespace gearfilm

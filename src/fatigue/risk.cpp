#include "fatigue/risk.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr int steps_between_depths = 16;  // even: of Simpson's rule

/// The cubic through four neighbouring amplitudes, those at k - 1 to k + 2 where there are so many.
double interpolated(std::span<const double> depths, std::span<const double> values, std::size_t k, double z) {
  const std::size_t count = std::min<std::size_t>(4, depths.size());
  const std::size_t first = std::min(k > 0 ? k - 1 : 0, depths.size() - count);
  double sum = 0.0;
  for (std::size_t i = first; i < first + count; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < first + count; ++j) {
      if (j != i) weight *= (z - depths[j]) / (depths[i] - depths[j]);
    }
    sum += weight * values[i];
  }
  return sum;
}

}  // namespace

double risk_of_depths(std::span<const double> depths, std::span<const double> amplitudes, const RiskOptions& options,
                      double from) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < depths.size(); ++k) {
    const double begin = std::max(from, depths[k]), end = depths[k + 1];
    if (!(end > begin)) continue;
    const double step = (end - begin) / steps_between_depths;
    for (int n = 0; n <= steps_between_depths; ++n) {
      const double z = begin + n * step;
      const double weight = n == 0 || n == steps_between_depths ? 1.0 : (n % 2 == 1 ? 4.0 : 2.0);
      const double excess = std::max(0.0, interpolated(depths, amplitudes, k, z) - options.threshold);
      if (excess == 0.0 || z <= 0.0) continue;
      sum += weight * step / 3.0 * std::pow(excess, options.stress_exponent) * std::pow(z, -options.depth_exponent);
    }
  }
  return sum;
}

double life_ratio(double risk, double reference, const RiskOptions& options) {
  return std::pow(reference / risk, 1.0 / options.weibull_slope);
}

}  // namespace gearfilm

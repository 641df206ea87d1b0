#include "fatigue/dang_van.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearfilm {
namespace {

using std::numbers::sqrt2;

/// Half the difference of the outer principal values of a deviator.
double shear_of(const DeviatorPoint& v) {
  static const double first = std::sqrt(2.0 / 3.0);
  const double xx = first * v[0], difference = sqrt2 * v[1];
  return largest_shear_stress({.xx = xx,
                               .yy = 0.5 * (difference - xx),
                               .zz = -0.5 * (difference + xx),
                               .yz = v[2] / sqrt2,
                               .xz = v[3] / sqrt2,
                               .xy = v[4] / sqrt2});
}

}  // namespace

DeviatorPoint deviator(const Stress& stress) {
  static const double first = std::sqrt(1.5);
  DeviatorPoint v;
  v << first * (stress.xx - hydrostatic(stress)), (stress.yy - stress.zz) / sqrt2, sqrt2 * stress.yz, sqrt2 * stress.xz,
      sqrt2 * stress.xy;
  return v;
}

double dang_van(std::span<const Stress> history, const DangVanOptions& options) {
  std::vector<DeviatorPoint> path;
  path.reserve(history.size());
  for (const Stress& stress : history) path.push_back(deviator(stress));
  const DeviatorPoint centre = smallest_ball(path).centre;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < history.size(); ++n) {
    const double pressure = hydrostatic(history[n]);
    const double counted = options.compression_helps ? pressure : std::max(pressure, 0.0);
    largest = std::max(largest, shear_of(path[n] - centre) + options.alpha * counted);
  }
  return largest;
}

std::vector<Stress> resampled(std::span<const double> times, std::span<const Stress> history, int parts) {
  const std::size_t n = history.size();
  std::vector<Stress> chord, slope, more;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    chord.push_back((1.0 / (times[k + 1] - times[k])) * (history[k + 1] + -1.0 * history[k]));
  }
  for (std::size_t k = 0; k < n && n > 1; ++k) {
    if (k == 0 || k + 1 == n) {
      slope.push_back(k == 0 ? chord.front() : chord.back());
    } else {
      const double before = (times[k] - times[k - 1]) / (times[k + 1] - times[k - 1]);
      slope.push_back((1.0 - before) * chord[k - 1] + before * chord[k]);
    }
  }
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double step = times[k + 1] - times[k];
    for (int part = 0; part < parts; ++part) {
      const double t = static_cast<double>(part) / parts, rest = 1.0 - t;
      more.push_back(((1.0 + 2.0 * t) * rest * rest) * history[k] + (t * t * (3.0 - 2.0 * t)) * history[k + 1] +
                     (step * t * rest * rest) * slope[k] + (-step * t * t * rest) * slope[k + 1]);
    }
  }
  if (n > 0) more.push_back(history.back());
  return more;
}

double dang_van_safety(double of_load, double limit, double residual_stress, double alpha) {
  return (limit - 2.0 * alpha * residual_stress / 3.0) / of_load;
}

}  // namespace gearfilm

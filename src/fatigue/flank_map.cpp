#include "fatigue/flank_map.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

constexpr int parts_of_a_step = 4;  // of resampled histories

}  // namespace

FlankMap flank_map(const FlankHistory& history, std::span<const double> points, int depths,
                   const DangVanOptions& options) {
  FlankMap map;
  for (const double s : points) {
    for (int depth = 0; depth < depths; ++depth) {
      const std::vector<Stress> passed = history.at(s, depth);
      double equivalent = 0.0, low = 0.0, high = 0.0;
      for (const Stress& stress : passed) {
        equivalent = std::max(equivalent, von_mises(stress));
        low = std::min(low, stress.xz);
        high = std::max(high, stress.xz);
      }
      map.dang_van.push_back(dang_van(resampled(passed, parts_of_a_step), options));
      map.von_mises.push_back(equivalent);
      map.orthogonal_amplitude.push_back(0.5 * (high - low));
    }
  }
  return map;
}

std::vector<double> flank_points(const FlankPath& path, int count) {
  std::vector<double> points(count);
  for (int n = 0; n < count; ++n) {
    points[n] = path.lowest() + (path.highest() - path.lowest()) * n / (count - 1);
  }
  return points;
}

}  // namespace gearfilm

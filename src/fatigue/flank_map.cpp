#include "fatigue/flank_map.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

constexpr int parts_of_a_step = 4;  // of resampled histories

/// Half the range of tau_xz, from no load on.
double orthogonal_amplitude(std::span<const Stress> history) {
  double low = 0.0, high = 0.0;
  for (const Stress& stress : history) {
    low = std::min(low, stress.xz);
    high = std::max(high, stress.xz);
  }
  return 0.5 * (high - low);
}

/// A contact may begin or end under load: what is before and behind it is no part of the smooth way between.
std::vector<Stress> from_no_load_to_none(const PointHistory& passed) {
  std::vector<Stress> history = resampled(passed.x, passed.stress, parts_of_a_step);
  history.insert(history.begin(), Stress{});
  history.emplace_back();
  return history;
}

}  // namespace

FlankMap flank_map(const FlankHistory& history, std::span<const double> points, int depths,
                   const DangVanOptions& options) {
  FlankMap map;
  for (const double s : points) {
    for (int depth = 0; depth < depths; ++depth) {
      const PointHistory passed = history.at(s, depth);
      double equivalent = 0.0;
      for (const Stress& stress : passed.stress) equivalent = std::max(equivalent, von_mises(stress));
      map.dang_van.push_back(dang_van(from_no_load_to_none(passed), options));
      map.von_mises.push_back(equivalent);
      map.orthogonal_amplitude.push_back(orthogonal_amplitude(passed.stress));
    }
  }
  return map;
}

std::vector<double> orthogonal_amplitudes(const FlankHistory& history, std::span<const double> points, int depths) {
  std::vector<double> amplitudes;
  for (const double s : points) {
    for (int depth = 0; depth < depths; ++depth)
      amplitudes.push_back(orthogonal_amplitude(history.at(s, depth).stress));
  }
  return amplitudes;
}

std::vector<double> flank_points(const FlankPath& path, int count) {
  std::vector<double> points(count);
  for (int n = 0; n < count; ++n) {
    points[n] = path.lowest() + (path.highest() - path.lowest()) * n / (count - 1);
  }
  return points;
}

}  // namespace gearfilm

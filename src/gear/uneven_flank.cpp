#include "gear/uneven_flank.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

UnevenFlank::UnevenFlank(std::vector<double> y, const std::vector<FlankCurve>& removed) : y_(std::move(y)) {
  const FlankCurve& middle = removed[removed.size() / 2];
  for (FlankCurve curve : removed) {
    for (std::size_t n = 0; n < curve.size(); ++n) curve[n].second -= middle[n].second;
    curves_.emplace_back(std::move(curve));
  }
}

void UnevenFlank::add(double rho, std::span<const double> y, std::span<double> values) const {
  if (even()) return;
  std::vector<double> known(curves_.size());
  std::ranges::transform(curves_, known.begin(), [&](const MonotoneCubic& curve) { return curve(rho); });
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double at = std::clamp(y[n], y_.front(), y_.back());
    const auto above = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(y_, at) - y_.begin(), 1,
                                                  static_cast<std::ptrdiff_t>(y_.size()) - 1);
    const auto k = static_cast<std::size_t>(above);
    values[n] += std::lerp(known[k - 1], known[k], (at - y_[k - 1]) / (y_[k] - y_[k - 1]));
  }
}

std::vector<double> UnevenProfile::gap(double x, std::span<const double> y) const {
  std::vector<double> sum(y.size(), 0.0);
  const double place = along ? x : 0.0;
  (*flanks)[0].add(radius_beside(rho[0], base_radius[0], -place), y, sum);
  (*flanks)[1].add(radius_beside(rho[1], base_radius[1], place), y, sum);
  return sum;
}

}  // namespace gearfilm

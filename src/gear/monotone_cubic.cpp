#include "gear/monotone_cubic.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

std::vector<double> monotone_slopes(const FlankCurve& points) {
  std::vector<double> slopes(points.size(), 0.0);
  const auto step = [&](std::size_t n) { return points[n + 1].first - points[n].first; };
  const auto secant = [&](std::size_t n) { return (points[n + 1].second - points[n].second) / step(n); };
  for (std::size_t n = 1; n + 1 < points.size(); ++n) {
    const double before = secant(n - 1), after = secant(n);
    if (before * after <= 0.0) continue;
    const double first = 2.0 * step(n) + step(n - 1), second = step(n) + 2.0 * step(n - 1);
    slopes[n] = (first + second) / (first / before + second / after);
  }
  return slopes;
}

}  // namespace

MonotoneCubic::MonotoneCubic(FlankCurve points) : points_(std::move(points)), slopes_(monotone_slopes(points_)) {}

double MonotoneCubic::operator()(double at) const {
  if (at <= points_.front().first) return points_.front().second;
  if (at >= points_.back().first) return points_.back().second;
  const auto above = std::ranges::upper_bound(points_, at, {}, &std::pair<double, double>::first);
  const std::size_t n = static_cast<std::size_t>(above - points_.begin()) - 1;
  const double h = points_[n + 1].first - points_[n].first, t = (at - points_[n].first) / h;
  const double rise = points_[n + 1].second - points_[n].second;
  return points_[n].second + rise * t * t * (3.0 - 2.0 * t) +
         h * t * (1.0 - t) * (slopes_[n] * (1.0 - t) - slopes_[n + 1] * t);
}

}  // namespace gearfilm

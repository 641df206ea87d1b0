#include "gear/flank.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

double relief(const Relief& of, double into) {
  if (into <= 0.0 || of.amount == 0.0) return 0.0;
  const double u = into / of.length;
  switch (of.shape) {
    case ReliefShape::linear:
      return of.amount * u;
    case ReliefShape::parabolic:
      return of.amount * u * u;
    case ReliefShape::smooth:
      break;
  }
  const double inside = std::min(u, 1.0);
  return of.amount * inside * inside * (3.0 - 2.0 * inside);
}

/// Slopes of a monotone cubic (Fritsch and Carlson): harmonic means where the secants have one sign, else zero.
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

double cubic(const FlankCurve& points, const std::vector<double>& slopes, double at) {
  if (at <= points.front().first) return points.front().second;
  if (at >= points.back().first) return points.back().second;
  const auto above = std::ranges::upper_bound(points, at, {}, &std::pair<double, double>::first);
  const std::size_t n = static_cast<std::size_t>(above - points.begin()) - 1;
  const double h = points[n + 1].first - points[n].first, t = (at - points[n].first) / h;
  const double rise = points[n + 1].second - points[n].second;
  return points[n].second + rise * t * t * (3.0 - 2.0 * t) +
         h * t * (1.0 - t) * (slopes[n] * (1.0 - t) - slopes[n + 1] * t);
}

}  // namespace

Flank::Flank(FlankModification modification, double start, double tip)
    : modification_(std::move(modification)), start_(start), tip_(tip) {
  for (const FlankCurve& curve : modification_.curves) slopes_.push_back(monotone_slopes(curve));
}

bool Flank::perfect() const {
  const FlankModification& m = modification_;
  return m.tip.amount == 0.0 && m.root.amount == 0.0 && m.slope == 0.0 && m.crowning == 0.0 && m.curves.empty();
}

double Flank::removed(double rho) const {
  const FlankModification& m = modification_;
  double sum = relief(m.tip, rho - (tip_ - m.tip.length)) + relief(m.root, start_ + m.root.length - rho);
  const double v = (rho - start_) / (tip_ - start_);
  sum += m.slope * v;
  if (m.crowning != 0.0) sum += m.crowning * (2.0 * v - 1.0) * (2.0 * v - 1.0);
  for (std::size_t n = 0; n < m.curves.size(); ++n) sum += cubic(m.curves[n], slopes_[n], rho);
  return sum;
}

}  // namespace gearfilm

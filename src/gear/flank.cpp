#include "gear/flank.hpp"

#include <algorithm>

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

}  // namespace

Flank::Flank(FlankModification modification, double start, double tip)
    : modification_(std::move(modification)), start_(start), tip_(tip) {
  for (const FlankCurve& curve : modification_.curves) curves_.emplace_back(curve);
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
  for (const MonotoneCubic& curve : curves_) sum += curve(rho);
  return sum;
}

}  // namespace gearfilm

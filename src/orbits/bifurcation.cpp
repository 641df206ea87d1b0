#include "gearfilm/orbits/bifurcation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace gearfilm {
namespace {

struct Test {
  PointKind kind;
  double (*value)(const BranchPoint&);
  /// Of a sign change at a point: it is what it looks like.
  bool (*real)(const BranchPoint&);
};

constexpr auto always = [](const BranchPoint&) { return true; };

// A pair of real multipliers whose product is 1 passes the test of Neimark and Sacker, but not the unit circle.
constexpr std::array<Test, 4> tests = {{
    {PointKind::fold, [](const BranchPoint& point) { return point.tangent[2]; }, always},
    {PointKind::flip,
     [](const BranchPoint& point) { return 1.0 + point.value.by_motion.trace() + point.value.by_motion.determinant(); },
     always},
    {PointKind::neimark_sacker, [](const BranchPoint& point) { return point.value.by_motion.determinant() - 1.0; },
     [](const BranchPoint& point) { return std::abs(point.value.by_motion.trace()) < 2.0; }},
    {PointKind::grazing, [](const BranchPoint& point) { return point.value.least_approach; }, always},
}};

bool changes(double before, double after) { return (before > 0.0) != (after > 0.0); }

BranchVector ahead(const BranchCorrector& corrector, const BranchPoint& from, double step) {
  return corrector.coordinates(from.state) + step * from.tangent;
}

/// Regula falsi (Illinois: the value at an end that stays is halved), with bisection where that is slow.
std::optional<Bifurcation> locate(const BranchCorrector& corrector, const Test& test, const BranchPoint& before,
                                  const Bifurcation& end, double tolerance) {
  constexpr int most_trials = 60;
  double low = 0.0, high = end.along, at_low = test.value(before), at_high = test.value(end.point);
  Bifurcation found{test.kind, high, end.point};
  for (int trial = 0; trial < most_trials && high - low > tolerance; ++trial) {
    const double part = trial % 4 == 3 ? 0.5 : std::clamp(at_low / (at_low - at_high), 0.01, 0.99);
    const double along = low + part * (high - low);
    const auto corrected = corrector.correct(ahead(corrector, before, along), before.tangent);
    if (!corrected) return {};
    const double value = test.value(corrected->point);
    found = {test.kind, along, corrected->point};
    if (value == 0.0) break;
    if (changes(at_low, value)) {
      high = along;
      at_high = value;
      at_low *= 0.5;
    } else {
      low = along;
      at_low = value;
      at_high *= 0.5;
    }
  }
  if (!test.real(found.point)) return {};
  return found;
}

}  // namespace

const char* name_of(PointKind kind) {
  constexpr std::array names = {"regular", "fold", "flip", "ns", "grazing"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Bifurcation> bifurcations_between(const BranchCorrector& corrector, const BranchPoint& before,
                                              const BranchPoint& after, double step, double tolerance) {
  std::vector<Bifurcation> found;
  for (const Test& test : tests) {
    if (!changes(test.value(before), test.value(after))) continue;
    if (auto there = locate(corrector, test, before, {test.kind, step, after}, tolerance)) {
      found.push_back(std::move(*there));
    }
  }
  std::ranges::sort(found, {}, &Bifurcation::along);
  return found;
}

bool meets_half_order(const BranchPoint& before, const BranchPoint& after) {
  const auto half = [](const BranchPoint& point) {
    return to_vector(difference(point.value.states[point.value.states.size() / 2 - 1], point.state.motion));
  };
  return half(before).dot(half(after)) < 0.0;
}

// (M + I) v = 0: v is normal to the longer row.
Motion flip_direction(const Monodromy& monodromy) {
  const Monodromy singular = monodromy + Monodromy::Identity();
  Eigen::Index longer = 0;
  if (singular.rowwise().squaredNorm().maxCoeff(&longer) == 0.0) return {1.0, 0.0};
  return to_motion(singular.row(longer).transpose().unitOrthogonal());
}

}  // namespace gearfilm

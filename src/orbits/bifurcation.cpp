#include "gearfilm/orbits/bifurcation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gearfilm {
namespace {

double trace(const Monodromy& m) { return m[0][0] + m[1][1]; }
double determinant(const Monodromy& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }

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
     [](const BranchPoint& point) { return 1.0 + trace(point.value.by_motion) + determinant(point.value.by_motion); },
     always},
    {PointKind::neimark_sacker, [](const BranchPoint& point) { return determinant(point.value.by_motion) - 1.0; },
     [](const BranchPoint& point) { return std::abs(trace(point.value.by_motion)) < 2.0; }},
    {PointKind::grazing, [](const BranchPoint& point) { return point.value.least_approach; }, always},
}};

bool changes(double before, double after) { return (before > 0.0) != (after > 0.0); }

BranchVector ahead(const BranchCorrector& corrector, const BranchPoint& from, double step) {
  BranchVector u = corrector.coordinates(from.state);
  for (int n = 0; n < 3; ++n) u[n] += step * from.tangent[n];
  return u;
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
  switch (kind) {
    case PointKind::fold:
      return "fold";
    case PointKind::flip:
      return "flip";
    case PointKind::neimark_sacker:
      return "ns";
    case PointKind::grazing:
      return "grazing";
    default:
      return "regular";
  }
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
    const Motion& middle = point.value.states[point.value.states.size() / 2 - 1];
    return Motion{middle.H0 - point.state.motion.H0, middle.V0 - point.state.motion.V0};
  };
  const Motion a = half(before), b = half(after);
  return a.H0 * b.H0 + a.V0 * b.V0 < 0.0;
}

// (M + I) v = 0: v is normal to the longer row.
Motion flip_direction(const Monodromy& monodromy) {
  const std::array<double, 2> first = {monodromy[0][0] + 1.0, monodromy[0][1]};
  const std::array<double, 2> second = {monodromy[1][0], monodromy[1][1] + 1.0};
  const double of_first = std::hypot(first[0], first[1]), of_second = std::hypot(second[0], second[1]);
  const auto& row = of_first > of_second ? first : second;
  const double size = std::max(of_first, of_second);
  if (size == 0.0) return {1.0, 0.0};
  return {-row[1] / size, row[0] / size};
}

}  // namespace gearfilm

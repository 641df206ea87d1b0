#include "orbits/bifurcation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

struct Test {
  PointKind kind;
  double (*value)(const BranchPoint&);
  /// Of a sign change at a point: it is what it looks like.
  bool (*real)(const BranchPoint&);
};

constexpr auto always = [](const BranchPoint&) { return true; };

double neimark_sacker(const BranchPoint& point) {
  const Multipliers mu = point.multipliers();
  std::complex<double> product = 1.0;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (std::size_t j = i + 1; j < mu.size(); ++j) product *= 1.0 - mu[i] * mu[j];
  }
  return product.real();
}

// Two real multipliers whose product is 1 pass the test of Neimark and Sacker, but not the unit circle.
bool complex_pair_on_the_circle(const BranchPoint& point) {
  const Multipliers mu = point.multipliers();
  double nearest = HUGE_VAL;
  bool complex = false;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (std::size_t j = i + 1; j < mu.size(); ++j) {
      const double away = std::abs(1.0 - mu[i] * mu[j]);
      if (away >= nearest) continue;
      nearest = away;
      complex = mu[i].imag() != 0.0;
    }
  }
  return complex;
}

const std::array<Test, 4> tests = {{
    {PointKind::fold, [](const BranchPoint& point) { return point.tangent[point.tangent.size() - 1]; }, always},
    {PointKind::flip,
     [](const BranchPoint& point) {
       const Monodromy& map = point.value.by_motion;
       return determinant(map + Monodromy::Identity(map.rows(), map.rows()));
     },
     always},
    {PointKind::neimark_sacker, neimark_sacker, complex_pair_on_the_circle},
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

// (M + I) v = 0
Motion flip_direction(const Monodromy& monodromy) {
  const Eigen::Index size = monodromy.rows();
  return to_motion(nearest_to_kernel(monodromy + Monodromy::Identity(size, size)));
}

}  // namespace gearfilm

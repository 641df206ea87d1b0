#include "gearfilm/orbits/branch_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

BranchVector sum(const BranchVector& a, double factor, const BranchVector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// The rows of P(x, lambda) - x.
struct Rows {
  BranchVector first, second;
};

Rows rows_of(const MapValue& value, double unit) {
  const auto& [first, second] = value.by_motion;
  return {{first[0] - 1.0, first[1], unit * value.by_parameter.H0},
          {second[0], second[1] - 1.0, unit * value.by_parameter.V0}};
}

}  // namespace

double dot(const BranchVector& a, const BranchVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const BranchVector& a) { return std::sqrt(dot(a, a)); }

BranchVector cross(const BranchVector& a, const BranchVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool BranchCorrector::finish(BranchPoint& point, const BranchVector& normal) const {
  try {
    if (point.value.measure) std::exchange(point.value.measure, {})(point.value);
  } catch (const SolveError&) {
    return false;
  }
  const auto [a, b] = rows_of(point.value, options_.unit);
  const BranchVector along = cross(a, b);
  const double size = std::copysign(length(along), dot(along, normal));
  if (size == 0.0) return false;
  point.tangent = {along[0] / size, along[1] / size, along[2] / size};
  return true;
}

// Three planes meet at u: with rows a, b and the normal n, (b x n, n x a, a x b)/(a . b x n) is the inverse matrix. A
// map that magnifies disturbances magnifies the noise of its image too: then it is the step that tells how near u is.
std::optional<BranchCorrector::Corrected> BranchCorrector::correct(const BranchVector& predicted,
                                                                   const BranchVector& normal) const {
  constexpr double farthest = 10.0;  // from the prediction: no orbit of that branch
  const double tolerance = options_.tolerance * order_;
  BranchVector u = predicted;
  for (int iteration = 0; iteration <= options_.most_iterations; ++iteration) {
    BranchPoint point{state(u), {}, {}};
    try {
      point.value = map_(point.state, order_);
    } catch (const SolveError&) {
      return {};
    }
    const auto [a, b] = rows_of(point.value, options_.unit);
    const double determinant = dot(cross(a, b), normal);
    if (determinant == 0.0) return {};
    const Motion defect = difference(point.value.image(), point.state.motion);
    BranchVector next = sum(u, -defect.H0 / determinant, cross(b, normal));
    next = sum(next, -defect.V0 / determinant, cross(normal, a));
    next = sum(next, -dot(normal, sum(next, -1.0, predicted)), normal);  // rounding off: back into the plane
    if (length(defect) < tolerance || length(sum(next, -1.0, u)) < tolerance) {
      if (!finish(point, normal)) return {};
      return Corrected{std::move(point), iteration};
    }
    u = next;
    if (!(length(sum(u, -1.0, predicted)) < farthest)) return {};
  }
  return {};
}

std::optional<BranchCorrector::Corrected> BranchCorrector::at_parameter(const BranchState& guess) const {
  return correct(coordinates(guess), {0.0, 0.0, 1.0});
}

}  // namespace gearfilm

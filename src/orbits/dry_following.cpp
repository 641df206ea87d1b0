#include "orbits/dry_following.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> smallest_step("dry_branch_smallest_step", 1.0 / 128,
                                  "smallest step along a dry branch, part of the way");
const Tuned<double> turn_in_a_step("dry_branch_turn_in_a_step", 0.3, "turn of the tangent in a step [rad]");
const Tuned<double> distance_of_a_step("dry_branch_distance_of_a_step", 0.2,
                                       "distance from prediction to motion, of a step's length");
const Tuned<double> other_branch("dry_branch_other_branch", 0.3, "distance from the prediction that is another branch");
const Tuned<double> same_motion("dry_branch_same_motion", 1e-3, "distance of motions that are the same");
const Tuned<double> tolerance("dry_branch_tolerance", 2e-8, "tolerance of a periodic motion of the dry pair");

/// Signed parts of the way are the unit of the parameter, so that a tangent's last component is positive.
Motion ahead(const BranchPoint& from, double parts) {
  const BranchVector& t = from.tangent;
  const Eigen::Index last = t.size() - 1;
  return to_motion(to_vector(from.state.motion) + parts / t[last] * t.head(last));
}

bool next_to_each_other(const BranchPoint& here, const BranchPoint& there, const Motion& predicted, double step) {
  const double turn = std::acos(std::clamp(here.tangent.dot(there.tangent), -1.0, 1.0));
  const double away = length(difference(there.state.motion, predicted));
  return turn < turn_in_a_step &&
         away < std::min<double>(other_branch, distance_of_a_step * step / here.tangent[here.tangent.size() - 1]);
}

}  // namespace

bool is_same_motion(const Motion& a, const Motion& b) { return length(difference(a, b)) <= same_motion; }

std::optional<Motion> follow_dry_branch(const MeshAt& mesh_at, int order, double damping_ratio, const BranchState& from,
                                        double to, const DryWatch& watch) {
  const double way = to - from.parameter, unit = std::abs(way), sign = way > 0.0 ? 1.0 : -1.0;
  if (unit == 0.0) return from.motion;
  const BranchMap map = [&watch, dry = dry_branch_map(mesh_at, damping_ratio, unit)](const BranchState& at, int k) {
    if (watch) watch(k);
    return dry(at, k);
  };
  const BranchCorrector corrector(map, order, {.unit = unit, .tolerance = tolerance});
  const auto begin = corrector.at_parameter(from);
  if (!begin || !is_same_motion(begin->point.state.motion, from.motion)) return {};
  BranchPoint here = begin->point;
  double done = 0.0, step = 1.0;
  while (done < 1.0) {
    step = std::min(step, 1.0 - done);
    const double parameter = done + step >= 1.0 ? to : from.parameter + (done + step) * way;
    const Motion predicted = ahead(here, sign * step);
    const auto next = corrector.at_parameter({predicted, parameter});
    if (next && next_to_each_other(here, next->point, predicted, step)) {
      here = next->point;
      done += step;
      step *= 2.0;
      continue;
    }
    step *= 0.5;
    if (step < smallest_step) return {};
  }
  return here.state.motion;
}

}  // namespace gearfilm

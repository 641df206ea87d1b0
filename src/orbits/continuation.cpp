#include "orbits/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> largest_turn("branch_largest_turn", 0.3, "largest turn of the tangent in a step [rad]");
const Tuned<double> usual_turn("branch_usual_turn", 0.1, "turn that the next step is chosen for [rad]");
const Tuned<double> farthest("branch_farthest", 0.5, "distance from prediction to corrected point, of a step");
const Tuned<int> easy_iterations(
    "branch_easy_iterations", 4,
    "iterations of the corrector up to which a step was easy, so that the next may be longer");

/// A flip whose branch is still to be followed.
struct Birth {
  int branch;
  int order;  ///< of the branch it is on
  BranchPoint at;
};

class BranchRun {
public:
  BranchRun(const BranchMap& map, const ContinuationOptions& options, const BranchObserver& observer, Branch& branch)
      : corrector_(map, branch.order, options.corrector), options_(options), observer_(observer), branch_(branch) {}

  /// From a point on it, in the direction of its tangent. Returns its flips.
  std::vector<BranchPoint> run(const BranchPoint& first) {
    report(PointKind::regular, first);
    BranchPoint here = first;
    double step = options_.first_step;
    branch_.end = BranchEnd::most_points;
    branch_.last = first.state;
    while (branch_.points < options_.most_points) {
      auto next = take(here, step);
      if (!next) {
        branch_.end = BranchEnd::lost;
        break;
      }
      if (ended(first, here, next->point, step)) break;
      happened(bifurcations_between(corrector_, here, next->point, step, options_.located));
      report(PointKind::regular, next->point);
      const double turn = angle(here.tangent, next->point.tangent);
      double growth = std::clamp(usual_turn / std::max(turn, 1e-12), 0.5, 1.5);
      if (next->iterations > easy_iterations) growth = std::min(growth, 0.7);
      step = std::clamp(growth * step, options_.smallest_step, options_.largest_step);
      here = std::move(next->point);
      branch_.last = here.state;
    }
    return std::move(flips_);
  }

  /// The first point of a branch born at a flip.
  std::optional<BranchPoint> beside(const BranchPoint& flip) const {
    const BranchVector at = corrector_.coordinates(flip.state);
    BranchVector across = BranchVector::Zero(at.size());
    across.head(at.size() - 1) = to_vector(flip_direction(flip.value.by_motion));
    double step = options_.first_step;
    while (step > options_.smallest_step) {
      const BranchVector predicted = at + step * across;
      auto found = corrector_.correct(predicted, across);
      if (found && fits(found->point, predicted, across, step)) return std::move(found->point);
      step *= 0.5;
    }
    return {};
  }

  std::optional<BranchPoint> at_parameter(const BranchState& guess) const {
    auto found = corrector_.at_parameter(guess);
    if (!found) return {};
    return std::move(found->point);
  }

private:
  double distance(const BranchPoint& point, const BranchVector& from) const {
    return (corrector_.coordinates(point.state) - from).norm();
  }
  static double angle(const BranchVector& a, const BranchVector& b) {
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
  }

  /// Near enough to its prediction to be on the same branch.
  bool fits(const BranchPoint& point, const BranchVector& predicted, const BranchVector& tangent, double step) const {
    return angle(tangent, point.tangent) < largest_turn && distance(point, predicted) < farthest * step;
  }

  /// The next point, with a step that is halved until it succeeds; nothing where the smallest does not.
  std::optional<BranchCorrector::Corrected> take(const BranchPoint& here, double& step) const {
    const BranchVector from = corrector_.coordinates(here.state);
    for (;; step *= 0.5) {
      if (step < options_.smallest_step) return {};
      const BranchVector predicted = from + step * here.tangent;
      auto next = corrector_.correct(predicted, here.tangent);
      if (next && fits(next->point, predicted, here.tangent, step)) {
        return next;
      }
    }
  }

  bool inside(const BranchPoint& point) const {
    return point.state.parameter >= options_.lowest && point.state.parameter <= options_.highest;
  }

  bool ended(const BranchPoint& first, const BranchPoint& here, const BranchPoint& next, double step) {
    if (branch_.order % 2 == 0 && meets_half_order(here, next)) {
      branch_.end = BranchEnd::at_flip;
    } else if (!inside(next)) {
      end_at_bound(here, next, step);
    } else if (returns(first, here, next, step)) {
      happened(bifurcations_between(corrector_, here, next, step, options_.located));
      report(PointKind::regular, first);
      branch_.end = BranchEnd::closed;
    } else {
      return false;
    }
    return true;
  }

  /// What happens up to the bound, and the point on it.
  void end_at_bound(const BranchPoint& here, const BranchPoint& next, double step) {
    branch_.end = BranchEnd::at_bound;
    std::vector<Bifurcation> before = bifurcations_between(corrector_, here, next, step, options_.located);
    std::erase_if(before, [&](const Bifurcation& found) { return !inside(found.point); });
    happened(std::move(before));
    const double bound = next.state.parameter > options_.highest ? options_.highest : options_.lowest;
    const double part = (bound - here.state.parameter) / (next.state.parameter - here.state.parameter);
    const BranchVector from = corrector_.coordinates(here.state), to = corrector_.coordinates(next.state);
    BranchState guess = corrector_.state(from + part * (to - from));
    guess.parameter = bound;
    if (auto last = at_parameter(guess)) {
      if (last->tangent.dot(here.tangent) < 0.0) last->tangent = -last->tangent;
      report(PointKind::regular, *last);
      branch_.last = last->state;
    }
  }

  /// Back through the first point.
  bool returns(const BranchPoint& first, const BranchPoint& here, const BranchPoint& next, double step) const {
    if (branch_.points < 4) return false;
    const BranchVector start = corrector_.coordinates(first.state);
    const double before = first.tangent.dot(corrector_.coordinates(here.state) - start);
    const double after = first.tangent.dot(corrector_.coordinates(next.state) - start);
    return before < 0.0 && after >= 0.0 && distance(next, start) <= 1.5 * step &&
           angle(first.tangent, next.tangent) < largest_turn;
  }

  void happened(std::vector<Bifurcation> found) {
    for (Bifurcation& bifurcation : found) {
      report(bifurcation.kind, bifurcation.point);
      if (bifurcation.kind == PointKind::flip) flips_.push_back(std::move(bifurcation.point));
    }
  }

  void report(PointKind kind, const BranchPoint& point) {
    ++branch_.points;
    observer_(branch_, kind, point);
  }

  BranchCorrector corrector_;
  const ContinuationOptions& options_;
  const BranchObserver& observer_;
  Branch& branch_;
  std::vector<BranchPoint> flips_;
};

/// Removes the birth of a branch that has just been followed to there from elsewhere.
void forget_birth(std::deque<Birth>& births, const Branch& done, const ContinuationOptions& options) {
  const BranchCorrector corrector({}, done.order, options.corrector);
  const auto away = [&](const Birth& birth) {
    if (birth.order * 2 != done.order) return HUGE_VAL;
    return (corrector.coordinates(birth.at.state) - corrector.coordinates(done.last)).norm();
  };
  const auto nearest = std::ranges::min_element(births, {}, away);
  if (nearest != births.end() && away(*nearest) < 2.0 * options.largest_step) births.erase(nearest);
}

}  // namespace

std::vector<Branch> follow_branches(const BranchMap& map, int order, const BranchState& guess, bool upwards,
                                    const ContinuationOptions& options, const BranchObserver& observer) {
  std::vector<Branch> branches;
  std::deque<Birth> births;
  const auto follow = [&](Branch branch, const BranchPoint& first) {
    BranchRun run(map, options, observer, branch);
    for (BranchPoint& flip : run.run(first)) {
      if (2 * branch.order <= options.largest_order) births.push_back({branch.number, branch.order, std::move(flip)});
    }
    if (branch.end == BranchEnd::at_flip) forget_birth(births, branch, options);
    branches.push_back(branch);
  };
  Branch trunk;
  trunk.order = order;
  std::optional<BranchPoint> start = BranchRun(map, options, observer, trunk).at_parameter(guess);
  if (!start) {
    throw SolveError(
        "no periodic motion of order ", order, " found next to the start of the branch: H0 = ", guess.motion.H0(),
        ", V0 = ", guess.motion.V0(), " where the parameter is ", guess.parameter,
        "; begin at another value (continuation.from), or at a motion that `gearfilm periodic` finds there "
        "(start.H0, start.V0)");
  }
  if (!upwards) start->tangent = -start->tangent;
  follow(trunk, *start);
  while (!births.empty()) {
    const Birth birth = std::move(births.front());
    births.pop_front();
    Branch branch{
        branches.back().number + 1, 2 * birth.order, birth.branch, 0, BranchEnd::lost, birth.at.state, birth.at.state};
    if (auto first = BranchRun(map, options, observer, branch).beside(birth.at)) {
      follow(branch, *first);
    } else {
      branches.push_back(branch);
    }
  }
  return branches;
}

}  // namespace gearfilm

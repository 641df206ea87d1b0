#include "orbits/dry_settling.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> least_damping("dry_settling_least_damping", 0.002, "damping ratio of a march that is to settle");
const Tuned<double> repeats_within("dry_settling_repeats_within", 1e-6, "change of the motion within which it repeats");
constexpr int fewest_patterns = 24, most_patterns = 3000;
const Tuned<int> patterns_between_looks("dry_settling_patterns_between_looks", 8, "patterns marched between two looks");

/// In which a disturbance dies away to 1e-8: it keeps exp(-2 pi zeta n) of itself over n free oscillations.
int patterns_to_settle(const DryMap& map, double damping_ratio) {
  const double oscillations = map.mesh().frequency() * map.mesh().path.mesh_period() * map.mesh().pattern;
  const double patterns = fewest_patterns + 3.0 / (damping_ratio * oscillations);
  return static_cast<int>(std::clamp(patterns, double{fewest_patterns}, double{most_patterns}));
}

/// Thrown to end a march that has come to repeat.
struct Repeats {};

Motion middle(const Motion& a, const Motion& b) { return {0.5 * (a.q + b.q), 0.5 * (a.v + b.v)}; }

}  // namespace

DrySettling settle_for_long(const DryMap& map, const Motion& from) {
  const double damping_ratio = std::max<double>(map.damping_ratio(), least_damping);
  const int pattern = map.mesh().pattern, patterns = patterns_to_settle(map, damping_ratio);
  DrySettling settling;
  int mesh_periods = 0;
  const auto on_period = [&](const DryPeriod& period) {
    if (map.watch()) map.watch()(1);
    if (++mesh_periods % pattern != 0) return;
    settling.points.push_back({.T = mesh_periods * map.mesh().path.mesh_period(), .motion = period.motion});
    const auto count = static_cast<int>(settling.points.size());
    if (count < fewest_patterns || count % patterns_between_looks != 0) return;
    settling.repeats_after = recurrence_of(settling.points, repeats_within)->period;
    if (settling.repeats_after > 0) throw Repeats{};
  };
  try {
    DryFlow::march(map.mesh(), damping_ratio, from, patterns * pattern, on_period);
  } catch (const Repeats&) {
  }
  settling.limit = settling.points.back().motion;
  settling.settles_on = settling.repeats_after;
  if (settling.repeats_after > 0) return settling;
  const std::optional<Settling> nears = settling_of(settling.points, {});
  if (nears && nears->contracts()) {
    settling.settles_on = nears->period;
    settling.limit = nears->limit;
  }
  return settling;
}

std::vector<Motion> near_unstable(const DrySettling& settling, int order) {
  constexpr std::size_t most = 4;
  constexpr double apart = 0.05;  // in (H_0, V_0): guesses nearer to one another lead to the same
  const std::vector<PoincarePoint>& points = settling.points;
  const auto step = static_cast<std::size_t>(order);
  std::vector<Motion> guesses;
  if (settling.settles_on == 2 * order && points.size() > step) {
    guesses.push_back(middle(points.back().motion, points[points.size() - 1 - step].motion));
  }
  std::vector<std::pair<double, Motion>> returns;
  for (std::size_t n = step; n < points.size(); ++n) {
    returns.emplace_back(length(difference(points[n].motion, points[n - step].motion)), points[n - step].motion);
  }
  std::ranges::stable_sort(returns, {}, &std::pair<double, Motion>::first);
  for (const std::pair<double, Motion>& candidate : returns) {
    if (guesses.size() == most) break;
    const bool known = std::ranges::any_of(
        guesses, [&](const Motion& guess) { return length(difference(guess, candidate.second)) < apart; });
    if (!known) guesses.push_back(candidate.second);
  }
  return guesses;
}

std::string what_it_does(const DrySettling& settling, const MeshModel& mesh) {
  const std::string marched = std::to_string(settling.points.size() * static_cast<std::size_t>(mesh.pattern));
  if (settling.settles_on == 0) {
    return "left to itself for " + marched + " mesh periods it neither repeats after up to " +
           std::to_string(8 * mesh.pattern) +
           " of them nor settles; look at the motion by `gearfilm transient`, or at "
           "its dots by a sweep of sweep.kind marches";
  }
  const std::string found = std::to_string(settling.settles_on * mesh.pattern) + " mesh period(s)";
  if (mesh.order % settling.settles_on == 0) {
    return "left to itself it comes to a motion that repeats after " + found +
           ", on which Newton's method does not converge; begin there: start.H0 = " +
           std::to_string(settling.limit.H0()) + ", start.V0 = " + std::to_string(settling.limit.V0());
  }
  return "left to itself it comes to a motion that repeats after " + found + "; try -periodic_order " +
         std::to_string(settling.settles_on);
}

}  // namespace gearfilm

#include "orbits/dry_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dynamics/dry_flow.hpp"
#include "gearfilm/error.hpp"
#include "grid/domain.hpp"
#include "numerics/tuned.hpp"
#include "orbits/dry_settling.hpp"

namespace gearfilm {
namespace {

const Tuned<double> strong_damping("dry_orbit_strong_damping", 0.3,
                                   "damping ratio with which a pair forgets its start");
const Tuned<double> weak_damping("dry_orbit_weak_damping", 0.002, "damping ratio from which it falls to none at once");
const Tuned<double> widest_ratio("dry_orbit_widest_ratio", 0.5, "ratio of one damping to the last");
const Tuned<double> narrowest_ratio("dry_orbit_narrowest_ratio", 0.97,
                                    "ratio of one damping to the last at which lowering is given up");
// Of H_0, off an orbit of first order: the way to where the pair settles may be a long one without order.
constexpr std::array pushes = {0.05, -0.05, 0.2, -0.2, 0.02, -0.02};
// Off the balance, of marches: as large as motions that lose contact.
constexpr std::array<std::array<double, 2>, 4> far_pushes = {{{0.0, 0.0}, {-1.0, 0.0}, {1.0, 0.0}, {0.0, 2.0}}};

// What damping takes in one mesh period: free oscillations in it times the damping ratio. Above this the pair forgets
// its start within a few mesh periods.
const Tuned<double> forgetful("dry_orbit_forgetful", 0.1,
                              "free oscillations in a mesh period times damping above which the pair forgets");

DryOrbit describe(const DryMap& map, const Motion& start) {
  const DryFlowEnd& end = map(start);
  return {start, end.by_start, end.extremes.largest_force};
}

/// The same, pushed by a displacement and a velocity of the flanks.
Motion pushed(const Motion& motion, double H0, double V0) {
  Motion result = motion;
  result.H0() += H0;
  result.V0() += V0;
  return result;
}

Motion at_rest(const MeshModel& mesh) { return DryMarch::balance(mesh, DryForce(mesh), 0.0); }

/// What the pair comes to from there within a few mesh periods.
Motion settle(const DryMap& map, const Motion& from) {
  const MeshModel& mesh = map.mesh();
  const double damping_ratio = std::max<double>(map.damping_ratio(), weak_damping);
  const double periods = std::ceil(10.0 + 2.0 / (damping_ratio * map.oscillations()));
  Motion end = from;
  DryFlow::march(mesh, damping_ratio, from, static_cast<int>(periods) * mesh.periods(), [&](const DryPeriod& period) {
    if (map.watch()) map.watch()(1);
    end = period.motion;
  });
  return end;
}

/// Where a branch of orbits ends on the way to less damping.
enum class BeyondItsEnd : std::uint8_t {
  settle,  ///< on with what the pair settles on there
  nothing  ///< there is no orbit; nor is it sought to the last where the branch ends
};

/// The orbit of a strongly damped pair, followed to less damping.
std::optional<Motion> follow_from_strong_damping(const DryMap& map, BeyondItsEnd beyond_its_end) {
  constexpr double soon = 0.85;
  const double narrowest = beyond_its_end == BeyondItsEnd::settle ? double(narrowest_ratio) : soon;
  const double least = map.damping_ratio(), weak = std::max<double>(weak_damping, least);
  double damping = std::max<double>(strong_damping, least), ratio = widest_ratio;
  const DryMap strong = map.at_damping(damping);
  std::optional<Motion> start = shoot(strong, settle(strong, at_rest(map.mesh())));
  while (start && damping > least) {
    const double next = ratio * damping < weak ? least : ratio * damping;
    if (const std::optional<Motion> trial = shoot(map.at_damping(next), *start)) {
      start = trial;
      damping = next;
      ratio = std::max<double>(widest_ratio, ratio * ratio);
      continue;
    }
    ratio = std::sqrt(ratio);
    if (ratio <= narrowest) continue;
    if (beyond_its_end == BeyondItsEnd::nothing) return {};
    // The branch ends: what the pair settles on with less damping is another one.
    const double less = std::max(widest_ratio * damping, weak);
    if (less >= damping) return {};
    const DryMap beyond = map.at_damping(less);
    start = shoot(beyond, settle(beyond, *start));
    damping = less;
    ratio = widest_ratio;
  }
  return start;
}

/// What the pair settles on when it is pushed off the orbit of first order: that one itself, where it is stable. Where
/// it is not, Newton's method may return to it from a motion that has not settled yet: another push leads away.
std::optional<Motion> find_beside_first_order(const DryMap& map) {
  constexpr double same_orbit = 1e-4;  // distance of motions
  MeshModel simple = map.mesh();
  simple.order = 1;
  try {
    const DryOrbit first_order = find_dry_orbit(simple, map.damping_ratio(), map.watch());
    const bool stable = largest_modulus(multipliers(first_order.monodromy)) < 1.0;
    for (const double push : pushes) {
      auto start = shoot(map, settle(map, pushed(first_order.start, push, 0.0)));
      if (start && (stable || length(difference(*start, first_order.start)) > same_orbit)) return start;
    }
  } catch (const SolveError&) {  // there is none of first order
  }
  return {};
}

/// By the ways that take least.
std::optional<Motion> find_soon(const DryMap& map) {
  if (map.mesh().order > 1) return find_beside_first_order(map);
  if (map.damping_ratio() * map.oscillations() > forgetful) {
    if (auto start = shoot(map, settle(map, at_rest(map.mesh())))) return start;
  }
  return follow_from_strong_damping(map, BeyondItsEnd::settle);
}

/// What a way finds; nothing where the pair parts for good on the way.
template <class Find>
std::optional<DryOrbit> described_if_found(const MeshModel& mesh, double damping_ratio, Find find) {
  const DryWatch none;
  const DryMap map(mesh, damping_ratio, none);
  try {
    if (const std::optional<Motion> start = find(map)) return describe(map, *start);
  } catch (const SolveError&) {
  }
  return {};
}

std::string none_found(const DryMap& map, const std::string& why) {
  return worded("no periodic orbit of the dry pair found that repeats after ", map.mesh().periods(),
                " mesh period(s), at damping ratio ", map.damping_ratio(), ": ", why);
}

/// By long marches from a motion and from others beside it; at last the unstable orbits that they pass. Throws
/// SolveError, which says what the first march comes to.
Motion find_by_marches(const DryMap& map, const Motion& from) {
  const int order = map.mesh().order;
  std::vector<DrySettling> marches;
  std::string trouble;
  for (const auto& push : far_pushes) {
    try {
      marches.push_back(settle_for_long(map, pushed(from, push[0], push[1])));
    } catch (const SolveError& error) {
      trouble = error.what();
      continue;
    }
    if (!marches.back().leads_to(order)) continue;
    if (auto start = shoot(map, marches.back().limit)) return *start;
  }
  if (marches.empty()) throw SolveError(none_found(map, trouble));
  for (const DrySettling& march : marches) {
    for (const Motion& guess : near_unstable(march, order)) {
      if (auto start = shoot(map, guess)) return *start;
    }
  }
  throw SolveError(none_found(map, what_it_does(marches.front(), map.mesh())));
}

}  // namespace

std::optional<DryOrbit> find_dry_orbit_soon(const MeshModel& mesh, double damping_ratio) {
  return described_if_found(mesh, damping_ratio, find_soon);
}

std::optional<DryOrbit> undamped_dry_orbit(const MeshModel& mesh) {
  return described_if_found(mesh, 0.0,
                            [](const DryMap& map) { return follow_from_strong_damping(map, BeyondItsEnd::nothing); });
}

DryOrbit find_dry_orbit(const MeshModel& mesh, double damping_ratio, const DryWatch& watch) {
  const DryMap map(mesh, damping_ratio, watch);
  if (const auto start = find_soon(map)) return describe(map, *start);
  return describe(map, find_by_marches(map, at_rest(mesh)));
}

double expected_film_damping(const MeshModel& mesh) {
  const double swing = 2.0 * std::numbers::pi * mesh.frequency();
  const double film = ExpectedFilm(mesh.scales).film / mesh.scales.approach;
  return std::max<double>(weak_damping, 0.6 * film / (1.0 + 5.0 * film) * swing / (0.6 + swing));
}

DryOrbit dry_start(const MeshModel& mesh) {
  if (mesh.inertia == 0.0) return {at_rest(mesh), {}};
  const DryWatch none;
  const DryMap damped(mesh, expected_film_damping(mesh), none);
  if (const auto start = find_soon(damped)) return describe(damped, *start);
  return {settle(damped, at_rest(mesh)), {}};
}

DryOrbit dry_orbit_from(const MeshModel& mesh, double damping_ratio, const Motion& near, const DryWatch& watch) {
  const DryMap map(mesh, damping_ratio, watch);
  if (const auto start = shoot(map, near)) return describe(map, *start);
  return dry_orbit_after(mesh, damping_ratio, near, watch);
}

DryOrbit dry_orbit_after(const MeshModel& mesh, double damping_ratio, const Motion& from, const DryWatch& watch) {
  const DryMap map(mesh, damping_ratio, watch);
  return describe(map, find_by_marches(map, mesh.in_train(from)));
}

std::optional<DryOrbit> follow_dry_orbit(const MeshModel& mesh, double damping_ratio, const Motion& near) {
  const DryWatch none;
  const DryMap map(mesh, damping_ratio, none);
  if (const auto start = shoot(map, near)) return describe(map, *start);
  return {};
}

}  // namespace gearfilm

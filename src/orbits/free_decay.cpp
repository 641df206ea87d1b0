#include "orbits/free_decay.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "numerics/tuned.hpp"
#include "orbits/affine_fit.hpp"
#include "orbits/map_jacobian.hpp"

namespace gearfilm {
namespace {

const Tuned<double> near_orbit("decay_near_orbit", 0.2, "part of a push that is near the orbit");
const Tuned<double> gone("decay_gone", 0.02, "part of a push that is noise");
const Tuned<double> far("decay_far", 4e-2, "distance from the orbit beyond which the map bends");
const Tuned<double> smallest_push("decay_smallest_push", 1e-4, "smallest push of a pair off its orbit");
const Tuned<double> well_known("decay_well_known", 0.02, "error of a modulus for which one push is enough");
const Tuned<double> of_grid_error("decay_of_grid_error", 0.5, "the same, over the error by the grid");

/// The pair has come back, to where it stays: near the orbit, which repeats within a tolerance only.
bool forgotten(const MeshModel& mesh, const Returns& motions, const Motion& orbit) {
  const double push = mesh.weighted_norm(difference(motions[0], orbit));
  const double last = mesh.weighted_norm(difference(motions.back(), motions[motions.size() - 2]));
  return last < gone * push && mesh.weighted_norm(difference(motions.back(), orbit)) < near_orbit * push;
}

/// The motion after 0, 1, 2, ... periods, until the push is gone, or has grown too far, or what there is suffices;
/// before each end, relative to the orbit, the motion from which it followed.
Returns returns_of(MeshMarch& march, const PeriodicOrbit& orbit, double push, const DecayOptions& options,
                   std::vector<Return>& leads, const std::function<bool(const Returns&)>& suffice) {
  const MeshModel& mesh = march.mesh();
  const Motion& begin = orbit.start.motion;
  march.resume(mesh.next_period(march.T()), orbit.start);
  Motion pushed = begin;
  pushed.q[0] += push;
  march.displace(pushed);
  Returns motions = {march.motion()};
  for (int n = 1; n <= options.periods; ++n) {
    const std::optional<PairState> before = march_period(march, options.lead);
    motions.push_back(march.motion());
    if (before && orbit.before) {
      leads.push_back({difference(before->motion, orbit.before->motion), difference(motions.back(), orbit.end.motion)});
    }
    if (n >= 2 &&
        (forgotten(mesh, motions, orbit.end.motion) || mesh.weighted_norm(difference(motions.back(), begin)) > far))
      break;
    if (n >= 3 && suffice(motions)) break;
  }
  return motions;
}

/// The motion a period after each q and v was pushed by itself, relative to the orbit, and the states there.
struct PushedPeriods {
  Monodromy map;
  std::vector<PairState> ends;
  std::vector<Return> leads;
};

PushedPeriods pushed_periods(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  const MeshModel& mesh = march.mesh();
  const Eigen::VectorXd begin = to_vector(orbit.start.motion), end = to_vector(orbit.end.motion);
  PushedPeriods found{Monodromy(begin.size(), begin.size()), {}, {}};
  for (Eigen::Index k = 0; k < begin.size(); ++k) {
    const bool velocity = k >= orbit.start.motion.freedoms();
    const double push = options.push / (velocity ? mesh.velocity_weight() : 1.0);
    march.resume(mesh.next_period(march.T()), orbit.start);
    march.displace(to_motion(begin + push * Eigen::VectorXd::Unit(begin.size(), k)));
    const std::optional<PairState> before = march_period(march, options.lead);
    const Eigen::VectorXd change = to_vector(march.motion()) - end;
    found.map.col(k) = change / push;
    found.ends.push_back(march.state());
    if (before && orbit.before)
      found.leads.push_back({difference(before->motion, orbit.before->motion), to_motion(change)});
  }
  return found;
}

/// Of a pair in a drive train.
FreeDecay decay_of_train(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  PushedPeriods pushed = pushed_periods(march, orbit, options);
  const EigenPairs eigen = eigen_pairs(pushed.map);
  Eigen::Index larger = 0;
  eigen.values.cwiseAbs().maxCoeff(&larger);
  const Eigen::RowVectorXcd mode = eigen.left.row(larger);
  const auto part_of = [&](const PairState& state) {
    const Eigen::VectorXd way = to_vector(difference(state.motion, orbit.end.motion));
    return std::abs((mode * way).value()) / march.mesh().weighted_norm(to_motion(way));
  };
  const PairState most = *std::ranges::max_element(pushed.ends, {}, part_of);
  march.resume(march.mesh().next_period(march.T()), most);
  march_period(march, options.lead);
  const Motion way = difference(most.motion, orbit.start.motion);
  const Motion came_to = difference(march.motion(), orbit.end.motion);
  const Eigen::VectorXd error = to_vector(came_to) - pushed.map * to_vector(way);
  MapJacobian map(way.freedoms(), march.mesh().velocity_weight(), pushed.map);
  map.update(way, came_to);
  FreeDecay decay{map.monodromy(), multipliers(map.monodromy()), 0.0};
  decay.fit_error = std::abs((mode * error).value() / (mode * to_vector(way)).value());
  pushed.leads.push_back({Motion::zero(way.freedoms()), Motion::zero(way.freedoms())});
  if (pushed.leads.size() > static_cast<std::size_t>(pushed.map.rows()))
    decay.lead_map = AffineFit(pushed.leads).map();
  return decay;
}

}  // namespace

FreeDecay fit_decay(const std::vector<Returns>& pushes, const Motion& begin, const Motion& end) {
  std::vector<Return> returns = {{Motion::zero(begin.freedoms()), difference(end, begin)}};
  for (const Returns& motions : pushes) {
    // The first period's films have not followed the push: it counts only where there is nothing better.
    for (std::size_t n = motions.size() > 3 ? 1 : 0; n + 1 < motions.size(); ++n) {
      returns.push_back({difference(motions[n], begin), difference(motions[n + 1], begin)});
    }
  }
  const AffineFit fit(returns);
  FreeDecay decay{fit.map(), multipliers(fit.map()), 0.0};
  const std::complex<double> larger = largest_multiplier(decay.multipliers);
  const bool spare = returns.size() > AffineFit::unknowns(begin);
  decay.fit_error = spare ? 2.0 * fit.deviation(larger) : std::abs(larger);
  return decay;
}

namespace {

/// How a pushed pair with one degree of freedom returns to its orbit.
FreeDecay decay_of_pair(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  const Motion& begin = orbit.start.motion;
  const auto near = [&](const Returns& motions) {
    return march.mesh().weighted_norm(difference(motions.back(), begin)) <= far;
  };
  const auto well_fitted = [&](const FreeDecay& decay) {
    return decay.fit_error < std::max<double>(well_known, of_grid_error * options.grid_error(decay.multipliers));
  };
  const auto alone = [&](const Returns& motions) { return well_fitted(fit_decay({motions}, begin, orbit.end.motion)); };
  const Motion none = Motion::zero(begin.freedoms());
  std::vector<Return> leads = {{none, none}};  // the orbit's own
  double push = options.push;
  Returns first = returns_of(march, orbit, push, options, leads, alone);
  while (!near(first) && 0.1 * push >= smallest_push) {
    push *= 0.1;
    leads.resize(1);
    first = returns_of(march, orbit, push, options, leads, alone);
  }
  if (forgotten(march.mesh(), first, orbit.end.motion)) {
    // Nothing is left to be fitted; how little, the first two returns say.
    const auto change = [&](int n) { return march.mesh().weighted_norm(difference(first[n], first[n - 1])); };
    const double kept = change(2) / change(1);
    Multipliers small(static_cast<std::size_t>(2 * begin.freedoms()));
    small.front() = kept;
    return {{}, small, kept};
  }
  FreeDecay decay = fit_decay({first}, begin, orbit.end.motion);
  if (!well_fitted(decay)) {
    const auto both = [&](const Returns& other_way) { return fit_decay({first, other_way}, begin, orbit.end.motion); };
    decay = both(returns_of(march, orbit, -push, options, leads,
                            [&](const Returns& other_way) { return well_fitted(both(other_way)); }));
  }
  if (leads.size() > AffineFit::unknowns(begin)) decay.lead_map = AffineFit(leads).map();
  return decay;
}

}  // namespace

FreeDecay free_decay(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  const bool alone = orbit.start.motion.freedoms() == 1;
  FreeDecay decay = alone ? decay_of_pair(march, orbit, options) : decay_of_train(march, orbit, options);
  decay.grid_error = options.grid_error(decay.multipliers);
  return decay;
}

}  // namespace gearfilm

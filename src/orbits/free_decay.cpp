#include "gearfilm/orbits/free_decay.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/orbits/affine_fit.hpp"

namespace gearfilm {
namespace {

constexpr double near_orbit = 0.2;      // of a push, from where it began
constexpr double gone = 0.02;           // of a push: what is left is noise
constexpr double far = 4e-2;            // beyond which the map bends
constexpr double smallest_push = 1e-4;  // noise is a hundredth of it

/// The pair has come back, to where it stays: near the orbit, which repeats within a tolerance only.
bool forgotten(const std::vector<Motion>& motions, const Motion& orbit) {
  const double push = length(difference(motions[0], orbit));
  const double last = length(difference(motions.back(), motions[motions.size() - 2]));
  return last < gone * push && length(difference(motions.back(), orbit)) < near_orbit * push;
}

/// The motion after 0, 1, 2, ... periods, until the push is gone, or has grown too far.
std::vector<Motion> returns_of(MeshMarch& march, const PeriodicOrbit& orbit, double push, int periods) {
  const MeshModel& mesh = march.mesh();
  const Motion& begin = orbit.start.motion;
  march.resume(mesh.next_period(march.T()), orbit.start);
  march.displace({begin.H0 + push, begin.V0});
  std::vector<Motion> motions = {march.motion()};
  for (int n = 1; n <= periods; ++n) {
    march.run(march.T() + mesh.period());
    motions.push_back(march.motion());
    if (n >= 2 && (forgotten(motions, orbit.end.motion) || length(difference(motions.back(), begin)) > far)) break;
  }
  return motions;
}

}  // namespace

FreeDecay fit_decay(const std::vector<Motion>& motions, const Motion& begin, const Motion& end) {
  std::vector<Return> returns = {{{}, difference(end, begin)}};
  // The first period's films have not followed the push: it counts only where there is nothing better.
  for (std::size_t n = motions.size() > 3 ? 1 : 0; n + 1 < motions.size(); ++n) {
    returns.push_back({difference(motions[n], begin), difference(motions[n + 1], begin)});
  }
  const AffineFit fit(returns);
  FreeDecay decay{fit.map(), multipliers(fit.map()), 0.0};
  const auto& mu = decay.multipliers;
  const std::complex<double> larger = std::abs(mu[0]) >= std::abs(mu[1]) ? mu[0] : mu[1];
  decay.modulus_error = returns.size() > 3 ? 2.0 * fit.deviation(larger) : std::abs(larger);
  return decay;
}

FreeDecay free_decay(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  const Motion& begin = orbit.start.motion;
  std::vector<Motion> motions;
  bool near = false;
  for (double push = options.push; push >= smallest_push && !near; push *= 0.1) {
    motions = returns_of(march, orbit, push, options.periods);
    near = length(difference(motions.back(), begin)) <= far;
  }
  if (forgotten(motions, orbit.end.motion)) {
    // Nothing is left to be fitted; how little, the first two returns say.
    const double kept = length(difference(motions[2], motions[1])) / length(difference(motions[1], motions[0]));
    return {{}, {kept, 0.0}, kept};
  }
  return fit_decay(motions, begin, orbit.end.motion);
}

}  // namespace gearfilm

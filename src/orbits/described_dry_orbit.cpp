#include "orbits/described_dry_orbit.hpp"

#include <cmath>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

/// Of the modulus of multipliers: their product is exp(-c T), c the damper's, with the trace of M^-1 C of a drive train
/// (Liouville).
double modulus_error(const MeshModel& mesh, double damping_ratio, const DryOrbit& orbit) {
  const double product = determinant(orbit.monodromy);
  double decay = -dry_damping(mesh, damping_ratio);
  if (mesh.train) decay = decay * mesh.inertia * mesh.train->by_force[0] + mesh.train->by_velocity.trace();
  const double expected = std::exp(decay * mesh.period());
  // Of one multiplier, so many of which are in the product.
  const auto one = [&mesh](double all) {
    return mesh.train ? std::pow(all, 0.5 / static_cast<double>(mesh.freedoms())) : std::sqrt(all);
  };
  return std::abs(one(std::abs(product)) - one(expected));
}

}  // namespace

DescribedOrbit find_described_dry_orbit(const OrbitProblem& problem, const StepObserver& observer,
                                        const DryWatch& watch) {
  const double zeta = problem.search.dry_damping_ratio;
  const std::optional<Motion>& near = problem.search.start;
  return describe(problem,
                  near ? dry_orbit_from(problem.mesh, zeta, *near, watch) : find_dry_orbit(problem.mesh, zeta, watch),
                  observer);
}

DescribedOrbit describe(const OrbitProblem& problem, const DryOrbit& orbit, const StepObserver& observer) {
  const MeshModel& mesh = problem.mesh;
  const double damping_ratio = problem.search.dry_damping_ratio;
  MarchStatistics statistics(mesh.period(), mesh.scales.static_force);
  MotionSignal signal;
  DescribedOrbit found;
  const auto on_step = [&](const StepRecord& record, const std::vector<ActiveContact>& none) {
    statistics.add(record, available_models(mesh, false));
    signal.add(record);
    const double mesh_periods = record.T / mesh.path.mesh_period(), next = std::round(mesh_periods);
    const bool leaving = std::abs(mesh_periods - next) < 1e-9 && next < static_cast<double>(mesh.periods());
    if (leaving && std::lround(next) == static_cast<long>(found.states_after_leaving.size())) {
      found.states_after_leaving.push_back(record.motion);
    }
    observer(record, none);
  };
  DryMarch march(mesh, problem.numerics.steps.dT, on_step, dry_damping(mesh, damping_ratio));
  march.start(orbit.start);
  march.run(mesh.period());
  found.orbit.start.motion = orbit.start;
  found.orbit.end.motion = march.motion();
  found.orbit.defect = length(difference(march.motion(), orbit.start));
  found.orbit.monodromy = orbit.monodromy;
  found.quantities = statistics.periods().at(0);
  found.contact_lost = statistics.contact_lost(0.0, mesh.period());
  found.transmission_error = signal.deviation(0.0, mesh.period());
  if (problem.search.with_multipliers) {
    found.decay = FreeDecay{orbit.monodromy, multipliers(orbit.monodromy), modulus_error(mesh, damping_ratio, orbit)};
  }
  return found;
}

}  // namespace gearfilm

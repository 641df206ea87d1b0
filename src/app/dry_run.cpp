#include "app/dry_run.hpp"

#include <Eigen/LU>
#include <cmath>

namespace gearfilm {
namespace {

/// Of the modulus of multipliers: their product is exp(-c T), c the damper's (Liouville).
double modulus_error(const MeshModel& mesh, double damping_ratio, const DryOrbit& orbit) {
  const double product = orbit.monodromy.determinant();
  const double expected = std::exp(-dry_damping(mesh, damping_ratio) * mesh.period());
  return std::abs(std::sqrt(std::abs(product)) - std::sqrt(expected));
}

}  // namespace

double dry_damping_ratio(const Case& problem) { return problem.march.dry_damping_ratio.value_or(typical_film_damping); }

DryWatch stopping(MPI_Comm comm, const StopRequest& stop) {
  return [comm, &stop, done = 0](int mesh_periods) mutable {
    done += mesh_periods;
    stop.check(comm, done);
  };
}

OrbitRun run_dry_orbit(const Case& problem, const MeshModel& mesh, const std::optional<Motion>& near,
                       const StepObserver& observer, const DryWatch& watch) {
  const double zeta = dry_damping_ratio(problem);
  const DryOrbit orbit = near ? dry_orbit_from(mesh, zeta, *near, watch) : find_dry_orbit(mesh, zeta, watch);
  return describe_dry_orbit(problem, mesh, orbit, observer);
}

OrbitRun describe_dry_orbit(const Case& problem, const MeshModel& mesh, const DryOrbit& orbit,
                            const StepObserver& observer) {
  const double damping_ratio = dry_damping_ratio(problem);
  MarchStatistics statistics(mesh.period(), mesh.scales.static_force);
  MotionSignal signal;
  OrbitRun run;
  const auto on_step = [&](const StepRecord& record, const std::vector<LiveContact>& none) {
    statistics.add(record, given_figures(mesh, false));
    signal.add(record);
    const double mesh_periods = record.T / mesh.path.mesh_period(), next = std::round(mesh_periods);
    const bool leaving = std::abs(mesh_periods - next) < 1e-9 && next < static_cast<double>(mesh.periods());
    if (leaving && std::lround(next) == static_cast<long>(run.states_after_leaving.size())) {
      run.states_after_leaving.push_back(record.motion);
    }
    observer(record, none);
  };
  DryMarch march(mesh, problem.numerics.steps.dT, on_step, dry_damping(mesh, damping_ratio));
  march.start(orbit.start);
  march.run(mesh.period());
  run.orbit.start.motion = orbit.start;
  run.orbit.end.motion = march.motion();
  run.orbit.defect = length(difference(march.motion(), orbit.start));
  run.orbit.monodromy = orbit.monodromy;
  run.figures = statistics.periods().at(0);
  run.contact_lost = statistics.contact_lost(0.0, mesh.period());
  run.transmission_error = signal.deviation(0.0, mesh.period());
  if (problem.search.with_multipliers) {
    run.decay = FreeDecay{orbit.monodromy, multipliers(orbit.monodromy), modulus_error(mesh, damping_ratio, orbit)};
  }
  return run;
}

}  // namespace gearfilm

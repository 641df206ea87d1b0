#include "app/branch_beginning.hpp"

#include "app/case_at.hpp"
#include "app/coarse_orbit.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/orbits/dry_branch.hpp"
#include "gearfilm/orbits/film_branch.hpp"

namespace gearfilm {
namespace {

/// Steps of a branch may go beyond what there is of pairs.
Case pair_at(const Case& problem, double value) {
  try {
    return case_at(problem, problem.continuation.parameter, value);
  } catch (const InputError& error) {
    throw SolveError(error.what());
  }
}

BranchMap dry_map(const Case& problem) {
  return dry_branch_map([&problem](double value) { return mesh_after_leaving(pair_at(problem, value)); },
                        dry_damping_ratio(problem), problem.continuation.options.corrector.unit);
}

/// Ends the run where it is to stop, but not for what is done again.
void check_stop(ResumableRun& run, const StepRecord& record, const MeshModel& mesh, MPI_Comm comm) {
  if (run.checkpoint().is_new(record)) run.stop().check(comm, record.T / mesh.path.mesh_period());
}

PeriodicOrbit orbit_at(const Case& problem, const SharedDiscretisation& films, const DryOrbit& dry, ResumableRun& run) {
  const OrbitObservers observers{.checkpoint = run.checkpoint(), .stop = run.stop()};
  Case without_multipliers = problem;
  without_multipliers.search.with_multipliers = false;
  return find_orbit(without_multipliers, films, mesh_after_leaving(problem), dry, observers).run.orbit;
}

}  // namespace

BranchBeginning dry_beginning(const Case& problem, const DryWatch& watch) {
  const double from = problem.continuation.from.value();
  const std::optional<Motion>& given = problem.march.start_motion;
  const auto found = [&] {
    return find_dry_orbit(mesh_after_leaving(pair_at(problem, from)), dry_damping_ratio(problem), watch).start;
  };
  const BranchMap map = [watch, dry = dry_map(problem)](const BranchState& at, int order) {
    watch(order);
    return dry(at, order);
  };
  return {map, {given ? *given : found(), from}, nullptr};
}

BranchBeginning film_beginning(const Case& problem, const SharedDiscretisation& films, ResumableRun& run) {
  const double from = problem.continuation.from.value();
  const Case first = pair_at(problem, from);
  MPI_Comm comm = films->grid().comm();
  const SharedDiscretisation films_there = discretise(comm, first);
  const DryOrbit dry = dry_start(mesh_after_leaving(first));
  FilmBranchOptions options{
      .unit = problem.continuation.options.corrector.unit, .lost = lost_force_ratio, .film_shift = 0.0, .films = {}};
  options.film_shift = dry_guess(first, films_there, dry).motion.H0() - dry.start.H0();
  BranchState state{problem.march.start_motion.value_or(dry.start), from};
  if (!problem.march.start_motion) {
    const PeriodicOrbit orbit = orbit_at(first, films_there, dry, run);
    state.motion = orbit.start.motion;
    options.films = orbit.end;
  }
  const auto mesh_periods = std::make_shared<double>(0.0);
  const MarchAt march_at = [&problem, &run, comm, mesh_periods](double value, int order, StepObserver observer) {
    Case here = pair_at(problem, value);
    here.search.order = order;
    const MeshModel mesh = mesh_after_leaving(here);
    const auto on_step = [&run, mesh, comm, mesh_periods, observer = std::move(observer)](
                             const StepRecord& record, const std::vector<LiveContact>& contacts) {
      observer(record, contacts);
      *mesh_periods += record.dT / mesh.path.mesh_period();
      check_stop(run, record, mesh, comm);
    };
    return make_march(here, discretise(comm, here), mesh, on_step, &run.checkpoint());
  };
  return {film_branch_map(march_at, dry_map(problem), options), state, mesh_periods};
}

}  // namespace gearfilm

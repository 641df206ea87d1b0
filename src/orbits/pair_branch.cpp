#include "orbits/pair_branch.hpp"

#include "dynamics/march_statistics.hpp"
#include "orbits/coarse_orbit.hpp"
#include "orbits/dry_branch.hpp"
#include "orbits/film_branch.hpp"

namespace gearfilm {
namespace {

BranchMap dry_map(const ProblemAt& problem_at, const BranchEntry& entry) {
  const double damping_ratio = problem_at(entry.from).search.dry_damping_ratio;
  return dry_branch_map([problem_at](double value) { return problem_at(value).mesh; }, damping_ratio, entry.unit);
}

PeriodicOrbit orbit_of(OrbitProblem problem, const SharedDiscretisation& films, const DryOrbit& dry,
                       const SearchWatch& watch) {
  problem.search.with_multipliers = false;
  return find_orbit(problem, films, dry, {.check_stop = watch.check_stop, .store = watch.store}).own.orbit;
}

}  // namespace

BranchBeginning dry_beginning(const ProblemAt& problem_at, const BranchEntry& entry, const DryWatch& watch) {
  const OrbitProblem first = problem_at(entry.from);
  const auto found = [&] { return find_dry_orbit(first.mesh, first.search.dry_damping_ratio, watch).start; };
  const BranchMap map = [watch, dry = dry_map(problem_at, entry)](const BranchState& at, int order) {
    watch(order);
    return dry(at, order);
  };
  return {map, {first.search.start ? *first.search.start : found(), entry.from}, nullptr};
}

BranchBeginning film_beginning(const ProblemAt& problem_at, const BranchEntry& entry, MPI_Comm comm,
                               const SearchWatch& watch) {
  const OrbitProblem first = problem_at(entry.from);
  const SharedDiscretisation films = discretise(comm, first);
  const DryOrbit dry = dry_start(first.mesh);
  FilmBranchOptions options{.unit = entry.unit, .lost = lost_force_ratio, .film_shift = 0.0, .films = {}};
  options.film_shift = dry_guess(first, films, dry).motion.H0() - dry.start.H0();
  BranchState state{first.search.start.value_or(dry.start), entry.from};
  if (!first.search.start) {
    const PeriodicOrbit orbit = orbit_of(first, films, dry, watch);
    state.motion = orbit.start.motion;
    options.films = orbit.end;
  }
  const auto mesh_periods = std::make_shared<double>(0.0);
  const MarchAt march_at = [problem_at, &watch, comm, mesh_periods](double value, int order, StepObserver observer) {
    OrbitProblem here = problem_at(value);
    here.mesh.order = order;
    const double mesh_period = here.mesh.path.mesh_period();
    const auto on_step = [mesh_period, mesh_periods, observer = std::move(observer)](
                             const StepRecord& record, const std::vector<ActiveContact>& contacts) {
      observer(record, contacts);
      *mesh_periods += record.dT / mesh_period;
    };
    return watched_march(here, discretise(comm, here), watch, on_step);
  };
  return {film_branch_map(march_at, dry_map(problem_at, entry), options), state, mesh_periods};
}

}  // namespace gearfilm

#include "gearfilm/input/case_setup.hpp"

#include "gearfilm/ehl/validity.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

GridShape case_grid(const Case& problem) {
  return grid_shape(problem.domain, problem.scales.hertz.ellipticity, problem.nx, problem.ny);
}

SharedDiscretisation discretise(MPI_Comm comm, const Case& problem) {
  return discretise(Grid(comm, case_grid(problem)), problem.scales);
}

void require_inertia(const Case& problem) {
  if (problem.line && (problem.equivalent_mass || problem.model == MarchModel::quasistatic)) return;
  throw InputError("the case '" + problem.name +
                   "' has no inertia to march in time; give gear.equivalent_mass, or pinion.inertia and "
                   "wheel.inertia, of a gear pair");
}

void require_moving_films(const Case& problem, const std::string& command) {
  const auto refuse = [&](const std::string& name, const std::string& needed) {
    throw InputError(problem.parameters.origin(name) + ": '" + name + "' is " + problem.parameters.text(name) +
                     ", but " + command + " is for all lubricated contacts, which travel; set it to " + needed);
  };
  if (problem.model != MarchModel::dynamic) refuse("model", "dynamic");
  if (problem.geometry == MeshGeometry::held) refuse("geometry", "moving");
}

MeshMarch make_march(const Case& problem, const SharedDiscretisation& films, const ContactPath& path,
                     StepObserver observer, MarchKeeper* keeper) {
  SolverOptions solver = problem.solver;
  solver.multigrid.levels =
      problem.step_levels > 0 ? problem.step_levels : step_levels(films->grid(), problem.steps.dT);
  const bool inert = problem.model != MarchModel::quasistatic;
  return MeshMarch(films, problem.scales, path, inert ? problem.scales.inertia(*problem.equivalent_mass) : 0.0, solver,
                   problem.steps, std::move(observer), problem.prescribed_load, keeper);
}

DryOrbit damped_dry_orbit(const Case& problem, const ContactPath& path) {
  return find_dry_orbit(problem.scales, path, problem.scales.inertia(*problem.equivalent_mass), usual_film_damping);
}

OrbitGuess dry_guess(const Case& problem, const SharedDiscretisation& films, const DryOrbit& dry) {
  ContactFilm film(films, problem.scales, problem.solver.multigrid);
  const StationaryResult at_pitch = located("contact at the pitch point", [&] {
    return solve_stationary(film, LoadCondition::force(problem.scales.static_force), problem.solver);
  });
  return guess_from(dry, at_pitch.solution.H0 + problem.scales.approach);
}

ContactPath path_after_leaving(const Case& problem) {
  const double start = problem.line->exit() - problem.line->base_pitch();
  return ContactPath(*problem.line, problem.scales, problem.pinion_speed, start);
}

}  // namespace gearfilm

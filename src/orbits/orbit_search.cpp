#include "orbits/orbit_search.hpp"

namespace gearfilm {

MeshMarch watched_march(const OrbitProblem& problem, const SharedDiscretisation& films, const SearchWatch& watch,
                        StepObserver on_step) {
  const double mesh_period = problem.mesh.path.mesh_period();
  const auto observer = [&watch, mesh_period, on_step = std::move(on_step)](
                            const StepRecord& record, const std::vector<ActiveContact>& contacts) {
    on_step(record, contacts);
    if (is_new(watch.store, record)) watch.check_stop(record.T / mesh_period);
  };
  return make_march(problem.mesh, problem.numerics, films, observer, watch.store);
}

OrbitGuess dry_guess(const OrbitProblem& problem, const FilmSolution& pitch_film, const DryOrbit& dry) {
  return guess_from(dry, pitch_film.H0 + problem.mesh.scales.approach);
}

OrbitGuess dry_guess(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry) {
  return dry_guess(problem, pitch_film(problem.mesh.scales, problem.numerics, films).solution, dry);
}

OrbitGuess first_guess(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry) {
  if (!problem.search.start) return dry_guess(problem, films, dry);
  OrbitGuess guess;
  guess.motion = *problem.search.start;
  guess.monodromy = dry.monodromy;
  return guess;
}

}  // namespace gearfilm

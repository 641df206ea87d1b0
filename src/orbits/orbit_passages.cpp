#include "orbits/orbit_passages.hpp"

namespace gearfilm {

std::vector<Passage> orbit_passages(const OrbitProblem& problem, const SharedDiscretisation& films,
                                    const PeriodicOrbit& orbit, const StopCheck& check_stop) {
  OrbitProblem recorded = problem;
  recorded.mesh.stress->keeps_sections = true;
  FlankRecorder recorder(problem.mesh, true);
  const SearchWatch watch{.check_stop = check_stop};
  MeshMarch march =
      watched_march(recorded, films, watch, [&](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
        recorder.observe(record, contacts);
      });
  march.resume(0.0, orbit.start);
  march.run(problem.mesh.period());
  return recorder.of_period(problem.mesh.periods());
}

}  // namespace gearfilm

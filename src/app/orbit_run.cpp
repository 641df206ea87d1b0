#include "app/orbit_run.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/march_output.hpp"
#include "gearfilm/input/case_setup.hpp"

namespace gearfilm {
namespace {

/// What is done again is not worth stopping for: the results of the program before would be replaced by fewer.
void check_stop(const OrbitObservers& observers, const StepRecord& record, MPI_Comm comm, const MeshModel& mesh) {
  if (observers.checkpoint.is_new(record)) observers.stop.check(comm, record.T / mesh.path.mesh_period());
}

/// A march of which nothing is kept but its end.
MeshMarch stoppable_march(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                          const OrbitObservers& observers) {
  const auto on_step = [&mesh, &observers, comm = films->grid().comm()](const StepRecord& record,
                                                                        const std::vector<LiveContact>&) {
    check_stop(observers, record, comm, mesh);
  };
  return make_march(problem, films, mesh, on_step, &observers.checkpoint);
}

}  // namespace

OrbitRun run_orbit(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                   const OrbitGuess& guess, const OrbitObservers& observers) {
  const double period = mesh.period();
  MarchStatistics statistics(period, mesh.scales.static_force);
  MotionSignal signal;
  std::map<long, Motion> after_leaving;  // by mesh periods
  bool searching = true;
  const auto on_step = [&](const StepRecord& record, const std::vector<LiveContact>& live) {
    if (searching) {
      statistics.add(record, given_figures(mesh, true));
      signal.add(record);
      const double mesh_periods = record.T / mesh.path.mesh_period();
      if (std::abs(mesh_periods - std::round(mesh_periods)) < 1e-9)
        after_leaving[std::lround(mesh_periods)] = record.motion;
      observers.on_step(record, live);
    }
    check_stop(observers, record, films->grid().comm(), mesh);
  };
  MeshMarch march = make_march(problem, films, mesh, on_step, &observers.checkpoint);
  OrbitRun run;
  run.orbit = find_periodic_orbit(march, guess, problem.search.options, observers.on_period);
  searching = false;
  const double begin = run.orbit.begin, end = begin + period;
  run.figures = statistics.periods().at(static_cast<std::size_t>(std::lround(begin / period)));
  run.states_after_leaving = {run.orbit.start.motion};
  const long first = std::lround(begin / mesh.path.mesh_period());
  for (long n = 1; n < mesh.periods(); ++n) run.states_after_leaving.push_back(after_leaving.at(first + n));
  run.memory = march.memory();
  run.contact_lost = statistics.contact_lost(begin, end);
  run.transmission_error = signal.deviation(begin, end);
  if (problem.search.with_multipliers) run.decay = free_decay(march, run.orbit, {.lead = problem.search.options.lead});
  return run;
}

OrbitGuess improve_guess(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                         const OrbitGuess& guess, const OrbitObservers& observers) {
  MeshMarch march = stoppable_march(problem, films, mesh, observers);
  return improved_guess(march, guess, observers.on_period);
}

FreeDecay decay_from(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh, const OrbitRun& run,
                     const OrbitObservers& observers) {
  MeshMarch march = stoppable_march(problem, films, mesh, observers);
  march.remember(run.memory);
  return free_decay(march, run.orbit, {.lead = problem.search.options.lead});
}

void add_multipliers(const MeshModel& mesh, const Multipliers& pair, Summary& summary) {
  const std::optional<FreeOscillation> oscillation =
      free_oscillation(pair, mesh.mesh_frequency_si() / mesh.periods(), mesh.frequency_si());
  summary["floquet"] = pair;
  const double modulus = largest_modulus(pair);
  summary["floquet_modulus"] = modulus;
  summary["stable"] = modulus < 1.0;
  summary["free_frequency"] = oscillation ? Summary(oscillation->frequency) : Summary();
  summary["damping_ratio"] = oscillation ? Summary(oscillation->damping_ratio) : Summary();
}

Summary orbit_summary(const MeshModel& mesh, const OrbitRun& run) {
  const Scales& scales = mesh.scales;
  Summary summary;
  summary["periods_used"] = run.orbit.periods_used;
  const bool lubricated = !run.orbit.end.films.empty();
  if (lubricated) summary["final_grid"] = grid_summary(scales, run.orbit.end.shape);
  summary["defect"] = run.orbit.defect;
  if (lubricated) summary["film_defect"] = run.orbit.film_defect;
  summary["states_after_leaving"] = run.states_after_leaving;
  summary["H0_after_leaving"] = run.orbit.start.motion.H0();
  summary["V0_after_leaving"] = run.orbit.start.motion.V0();
  summary.update(period_summary(scales, run.figures));
  summary["contact_lost"] = run.contact_lost;
  summary["back_contact"] = run.figures["back_force_ratio_max"].value_or(0.0) > 0.0;
  summary["transmission_error_peak_to_peak"] = scales.thickness * run.transmission_error.peak_to_peak;
  summary["transmission_error_rms"] = scales.thickness * run.transmission_error.root_mean_square;
  if (run.decay) {
    add_multipliers(mesh, run.decay->multipliers, summary);
    summary["floquet_modulus_error"] = run.decay->modulus_error;
  }
  return summary;
}

}  // namespace gearfilm

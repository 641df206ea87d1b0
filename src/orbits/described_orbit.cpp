#include "orbits/described_orbit.hpp"

#include <cmath>
#include <map>

#include "orbits/multiplier_error.hpp"

namespace gearfilm {
namespace {

FreeDecay decay_after(MeshMarch& march, const OrbitProblem& problem, const PeriodicOrbit& orbit) {
  const auto grid_error = [&](const Multipliers& found) { return multiplier_grid_error(problem, found); };
  return free_decay(march, orbit, {.lead = problem.search.options.lead, .grid_error = grid_error});
}

}  // namespace

DescribedOrbit find_described_orbit(const OrbitProblem& problem, const SharedDiscretisation& films,
                                    const OrbitGuess& guess, const SearchWatch& watch) {
  const MeshModel& mesh = problem.mesh;
  const double period = mesh.period(), mesh_period = mesh.path.mesh_period();
  MarchStatistics statistics(period, mesh.scales.static_force);
  PitchFilmRecorder pitch_films(mesh);
  MotionSignal signal;
  std::map<long, Motion> after_leaving;  // by mesh periods
  bool searching = true;
  const auto on_step = [&](const StepRecord& record, const std::vector<ActiveContact>& live) {
    if (!searching) return;
    statistics.add(record, available_models(mesh, true));
    pitch_films.add(record);
    signal.add(record);
    const double mesh_periods = record.T / mesh_period;
    if (std::abs(mesh_periods - std::round(mesh_periods)) < 1e-9)
      after_leaving[std::lround(mesh_periods)] = record.motion;
    watch.on_step(record, live);
  };
  MeshMarch march = watched_march(problem, films, watch, on_step);
  DescribedOrbit found;
  found.orbit = find_periodic_orbit(march, guess, problem.search.options, watch.on_period);
  searching = false;
  const double begin = found.orbit.begin, end = begin + period;
  found.quantities = statistics.periods().at(static_cast<std::size_t>(std::lround(begin / period)));
  found.pitch_films = pitch_films.within(begin, end);
  found.states_after_leaving = {found.orbit.start.motion};
  const long first = std::lround(begin / mesh_period);
  for (long n = 1; n < mesh.periods(); ++n) found.states_after_leaving.push_back(after_leaving.at(first + n));
  found.memory = march.memory();
  found.contact_lost = statistics.contact_lost(begin, end);
  found.transmission_error = signal.deviation(begin, end);
  if (problem.search.with_multipliers) found.decay = decay_after(march, problem, found.orbit);
  return found;
}

OrbitGuess newton_step(const OrbitProblem& problem, const SharedDiscretisation& films, const OrbitGuess& guess,
                       const SearchWatch& watch) {
  MeshMarch march = watched_march(problem, films, watch);
  return improved_guess(march, guess, watch.on_period);
}

FreeDecay decay_from(const OrbitProblem& problem, const SharedDiscretisation& films, const DescribedOrbit& found,
                     const SearchWatch& watch) {
  MeshMarch march = watched_march(problem, films, watch);
  march.remember(found.memory);
  return decay_after(march, problem, found.orbit);
}

std::size_t true_order(const std::vector<Motion>& states, double tolerance) {
  for (std::size_t order = 1; order < states.size(); ++order) {
    if (states.size() % order != 0) continue;
    bool same = true;
    for (std::size_t n = order; n < states.size(); ++n) {
      same = same && length(difference(states[n], states[n - order])) < tolerance;
    }
    if (same) return order;
  }
  return states.size();
}

}  // namespace gearfilm

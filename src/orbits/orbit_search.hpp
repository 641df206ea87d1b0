// What a search for a periodic state of a lubricated pair is given: the pair, its numerical choices, those of the
// search, and who watches it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "dynamics/pair_numerics.hpp"
#include "orbits/periodic_orbit.hpp"

namespace gearfilm {

struct OrbitSearch {
  PeriodicOptions options;
  bool with_multipliers = true;                     ///< Floquet multipliers too, by up to eight more periods
  bool multipliers_on_own_grid = false;             ///< and not on a coarser one where that will do
  std::optional<Motion> start{};                    ///< where it begins; absent: by the dry pair's orbit
  double dry_damping_ratio = typical_film_damping;  ///< of dry pairs' orbits
};

struct OrbitProblem {
  MeshModel mesh;  ///< a contact has just left at T = 0
  PairNumerics numerics;
  OrbitSearch search;
};

/// What all films of the problem share on its first grid. Collective.
inline SharedDiscretisation discretise(MPI_Comm comm, const OrbitProblem& problem) {
  return discretise(comm, problem.numerics, problem.mesh.scales);
}

/// Throws Stopped where a run is to end; called with the number of mesh periods marched so far. Collective.
using StopCheck = std::function<void(double mesh_periods)>;

/// A StopCheck for searches of dry orbits, which report the mesh periods marched since their last report.
inline DryWatch counted(StopCheck check) {
  return [check = std::move(check), done = 0](int mesh_periods) mutable {
    done += mesh_periods;
    check(done);
  };
}

/// Who watches searches: every accepted step, and every period marched, until the orbit is found.
struct SearchWatch {
  StepObserver on_step = unseen;
  SearchObserver on_period = [](const SearchPeriod&) {};
  SearchObserver on_coarse_period = on_period;  ///< of a search on a coarser grid, before
  /// Why there is none on it: the search goes on without.
  std::function<void(const std::string&)> on_trouble = [](const std::string&) {};
  StopCheck check_stop = [](double) {};
  RunStore* store = nullptr;  ///< keeps all marches, and may know a part
};

/// A march of the problem, which ends where the watch says so, but not during steps that an earlier program has made
/// and that are only taken over. on_step is called before the watch. The watch must outlive the march.
MeshMarch watched_march(const OrbitProblem& problem, const SharedDiscretisation& films, const SearchWatch& watch,
                        StepObserver on_step = unseen);

/// Where the search for the pair's orbit begins: a dry orbit, its H_0 shifted by the film at the pitch point.
OrbitGuess dry_guess(const OrbitProblem& problem, const FilmSolution& pitch_film, const DryOrbit& dry);
OrbitGuess dry_guess(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry);
/// The guess with which a search begins: the motion of OrbitSearch::start where there is one, else dry_guess.
OrbitGuess first_guess(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry);

}  // namespace gearfilm

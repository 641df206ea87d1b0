// Searches of periodic states on every second node, at first with twice the time step where that tells them: they begin
// those on the problem's own grid, and say what those have wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "orbits/described_orbit.hpp"

namespace gearfilm {

/// The problem on the coarser grid, where its films have one.
std::optional<OrbitProblem> coarser_problem(const OrbitProblem& problem, Discretisation& films);

/// For error bars alone.
OrbitProblem searched_briefly(OrbitProblem problem);

/// What watches marches that only lead to the orbit.
SearchWatch on_the_way(const SearchWatch& watch, RunStore* store);

/// What watches a search on a coarser grid, which is given up where too many of its steps are halved.
SearchWatch on_coarser_grid(const SearchWatch& watch, RunStore* store, const MeshModel& mesh);

/// Its steps tell the orbit, and how it damps.
bool resolves_swings(const OrbitProblem& problem);

/// Words before what is said of a march there.
std::string place_of(const PairNumerics& numerics);

/// The orbits on the coarser grid, one from the other.
class CoarseSearch {
public:
  /// coarse: the problem on half the nodes with twice the time step. fine: the problem of the case, whose step is taken
  /// where twice that is too long, and which says whether multipliers are wanted. The watch is kept by reference.
  CoarseSearch(const OrbitProblem& coarse, const OrbitProblem& fine, const SearchWatch& watch, MPI_Comm comm);

  /// With which a search begins: with twice the step, where the pair stays in phase and films follow it.
  const OrbitProblem& problem() const { return doubles_the_step_ ? twice_the_step_ : own_step_; }
  const SharedDiscretisation& films() const { return films_; }
  bool has_twice_the_step() const { return doubles_the_step_; }
  /// Whether a search there was given up for its halved steps.
  bool has_too_many_halved() const { return too_many_halved_; }

  /// The film at the pitch point under the static force, solved for once. Throws SolveError.
  const FilmSolution& pitch_film() const;

  /// Nothing, and the reason to the watch, where its films cannot be solved; the name is that of its checkpoint;
  /// patience as in PeriodicOptions. Throws NoPeriodicState.
  std::optional<DescribedOrbit> orbit(const std::string& name, const std::function<OrbitGuess()>& guess,
                                      std::optional<int> patience = {});
  /// What an orbit with the step of the case itself has with one that is longer by the ratio. Nothing where it has none
  /// that is found about as soon.
  std::optional<DescribedOrbit> with_longer_step(const DescribedOrbit& found, double ratio);
  /// An orbit with its decay, where multipliers are asked for.
  DescribedOrbit with_decay(DescribedOrbit run);
  /// Where a search from an orbit that was found here begins: with the map of its decay, where that is known well.
  OrbitGuess guess_from(const DescribedOrbit& run) const;

private:
  std::optional<DescribedOrbit> orbit_of(const std::string& name, const OrbitProblem& coarse,
                                         const std::function<OrbitGuess()>& guess);
  template <class Result, class March>
  std::optional<Result> attempt(const std::string& name, const OrbitProblem& coarse, March march);

  OrbitProblem twice_the_step_;
  OrbitProblem own_step_;
  const SearchWatch& watch_;
  bool doubles_the_step_;
  bool with_multipliers_;
  bool too_many_halved_ = false;
  NewtonOptions newton_of_decay_;
  SharedDiscretisation films_;
  mutable std::optional<FilmSolution> pitch_film_;
};

/// By how much the pair lies higher on the films of the problem's own grid: as much as one contact at rest does.
double film_shift(const CoarseSearch& coarse, const OrbitProblem& problem, const SharedDiscretisation& films);

/// The orbit of the coarser grid as a guess on the problem's own: pressures interpolated, the bodies moved apart by as
/// much as its films are thicker.
OrbitGuess guess_on_grid(const OrbitProblem& problem, const SharedDiscretisation& films, const CoarseSearch& search,
                         const DescribedOrbit& coarse);

}  // namespace gearfilm

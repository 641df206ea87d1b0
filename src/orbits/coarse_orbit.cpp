#include "orbits/coarse_orbit.hpp"

#include <cmath>
#include <vector>

#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"
#include "orbits/coarse_search.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

const Tuned<double> many_node_steps(
    "search_many_node_steps", 4e6,
    "nodes times steps of a mesh period from which the coarser grid begins on one coarser still");
const Tuned<int> patience("search_patience", 10,
                          "periods in which the first searches have to come twice as near to repeating");
const Tuned<double> more_damping("search_more_damping", 3.0, "damping of a further start, over the expected one");
const Tuned<double> same_orbit("search_same_orbit", 0.1, "distance of the motions of one orbit on two grids");
const Tuned<double> near_one("search_near_one", 1.25,
                             "distance of a multiplier from one, in its errors, within which the own grid decides");

/// The failure of the problem's own grid, and that the coarser one may serve.
SolveError with_remedy(const SolveError& failure, const PairNumerics& coarse) {
  return SolveError(failure.what(), "; on ", coarse.nx, " x ", coarse.ny,
                    " nodes (grid_nx, grid_ny) a periodic state was found, with the errors of that grid");
}

/// first_guess with the pitch film of the search.
OrbitGuess guess_of(const CoarseSearch& search, const DryOrbit& dry) {
  const OrbitProblem& problem = search.problem();
  if (problem.search.start) return first_guess(problem, search.films(), dry);
  return dry_guess(problem, search.pitch_film(), dry);
}

/// Where the search on the coarser grid begins: where a mesh period is long even there, on the orbit of one that is
/// coarser still, with its step and its tolerances; else on the dry pair's.
OrbitGuess first_coarse_guess(const CoarseSearch& search, const DryOrbit& dry, const SearchWatch& watch) {
  const OrbitProblem& problem = search.problem();
  const double steps = problem.mesh.period() / problem.numerics.steps.dT;
  std::optional<OrbitProblem> coarser = coarser_problem(problem, *search.films());
  if (coarser && steps * problem.numerics.nx * problem.numerics.ny > many_node_steps) {
    coarser->search.options = problem.search.options;
    coarser->numerics.steps = problem.numerics.steps;
    CoarseSearch first(*coarser, problem, watch, search.films()->grid().comm());
    try {
      const std::optional<DescribedOrbit> found = first.orbit("coarsest", [&] { return guess_of(first, dry); });
      if (found) return guess_on_grid(problem, search.films(), first, *found);
    } catch (const NoPeriodicState& error) {
      watch.on_trouble(error.what());
    }
  }
  return guess_of(search, dry);
}

/// From the dry orbit given, or else from one that is damped less or more; nothing where none leads to one.
std::optional<DescribedOrbit> first_coarse_orbit(CoarseSearch& search, const DryOrbit& dry, const SearchWatch& watch) {
  struct Start {
    std::string name;
    std::function<std::optional<DryOrbit>()> orbit;
  };
  std::vector<Start> starts = {{"coarse", [&dry] { return dry; }}};
  const MeshModel& mesh = search.problem().mesh;
  if (mesh.inertia > 0.0) {
    const double expected = expected_film_damping(mesh);
    const auto damped = [&mesh](double ratio) { return [&mesh, ratio] { return find_dry_orbit_soon(mesh, ratio); }; };
    if (expected > typical_film_damping) starts.push_back({"coarse_less_damped", damped(typical_film_damping)});
    starts.push_back({"coarse_more_damped", damped(more_damping * expected)});
  }
  for (std::size_t n = 0; n < starts.size(); ++n) {
    const std::optional<DryOrbit> start = starts[n].orbit();
    if (!start) continue;
    std::optional<int> most;
    if (n + 1 < starts.size()) most = patience;
    try {
      const auto guess = [&] { return first_coarse_guess(search, *start, watch); };
      if (std::optional<DescribedOrbit> found = search.orbit(starts[n].name, guess, most)) return found;
    } catch (const NoPeriodicState& error) {
      watch.on_trouble(error.what());
    }
    if (n == 0 && search.has_too_many_halved()) return {};
  }
  return {};
}

/// The guess after a period with twice the step, where that resolves the swings: films of another case need a march to
/// become those of this one.
OrbitGuess with_marched_films(const OrbitProblem& problem, const SharedDiscretisation& films, const OrbitGuess& guess,
                              const SearchWatch& watch) {
  OrbitProblem quick = problem;
  quick.numerics.steps.lengthen(2.0);
  if (!guess.neighbour || !resolves_swings(quick)) return guess;
  const std::unique_ptr<RunStore> store = store_within(watch.store, "near_step", films->grid());
  try {
    return newton_step(quick, films, guess, on_the_way(watch, store.get()));
  } catch (const SolveError&) {
    return guess;
  }
}

/// That of the coarser grid; that of the own where it is asked for, where there is no other, and where the larger
/// multiplier of the other may be on the wrong side of one.
FreeDecay decay_of(const OrbitProblem& problem, const SharedDiscretisation& films, const DescribedOrbit& found,
                   const std::optional<FreeDecay>& coarse, const SearchWatch& watch) {
  const auto clear = [](const FreeDecay& decay) {
    return std::abs(largest_modulus(decay.multipliers) - 1.0) > near_one * decay.modulus_error();
  };
  if (coarse && !problem.search.multipliers_on_own_grid && clear(*coarse)) return *coarse;
  const std::unique_ptr<RunStore> store = store_within(watch.store, "decay", films->grid());
  try {
    return decay_from(problem, films, found, on_the_way(watch, store.get()));
  } catch (const SolveError& error) {
    if (!coarse) throw;
    watch.on_trouble(error.what());
    return *coarse;
  }
}

/// The return of the pair to the orbit next to this one on the coarser grid; nothing where it has none.
std::optional<FreeDecay> coarse_decay(const OrbitProblem& problem, const SharedDiscretisation& films,
                                      const PeriodicOrbit& orbit, const SearchWatch& watch) {
  const std::optional<OrbitProblem> coarse = coarser_problem(problem, *films);
  if (!coarse) return {};
  CoarseSearch search(*coarse, problem, watch, films->grid().comm());
  OrbitGuess guess{orbit.start.motion, orbit.monodromy, {}};
  guess.motion.H0() -= film_shift(search, problem, films);
  try {
    const std::optional<DescribedOrbit> found = search.orbit("coarse", [&] { return guess; });
    if (!found || problem.mesh.weighted_norm(difference(found->orbit.start.motion, guess.motion)) > same_orbit)
      return {};
    return search.with_decay(*found).decay;
  } catch (const SolveError&) {
    return {};
  }
}

}  // namespace

FoundOrbit find_orbit(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry,
                      const SearchWatch& watch) {
  FoundOrbit found{.discretisation = problem.numerics.discretisation};
  std::optional<OrbitGuess> guess;
  std::optional<DescribedOrbit> nearest;
  const std::optional<OrbitProblem> coarse = coarser_problem(problem, *films);
  if (coarse) {
    CoarseSearch search(*coarse, problem, watch, films->grid().comm());
    const std::optional<DescribedOrbit> first = first_coarse_orbit(search, dry, watch);
    if (first) {
      if (!search.has_twice_the_step()) found.longer_step = search.with_longer_step(*first, FoundOrbit::step_ratio);
      if (search.has_twice_the_step() || found.longer_step) found.coarse = first;
      nearest = search.with_decay(*first);
      guess = guess_on_grid(problem, films, search, *nearest);
    }
  }
  if (!guess) guess = first_guess(problem, films, dry);
  OrbitProblem last = problem;
  const bool has_decay = nearest && nearest->decay;
  if (has_decay) last.search.with_multipliers = false;
  try {
    found.own = find_described_orbit(last, films, *guess, watch);
  } catch (const SolveError& error) {
    if (nearest) throw with_remedy(error, coarse->numerics);
    throw;
  }
  if (has_decay) found.own.decay = decay_of(problem, films, found.own, nearest->decay, watch);
  return found;
}

DescribedOrbit find_orbit_with_coarse_start(const OrbitProblem& problem, const SharedDiscretisation& films,
                                            const OrbitGuess& neighbour, const SearchWatch& watch) {
  OrbitProblem alone = problem;
  alone.search.with_multipliers = false;
  const OrbitGuess guess = with_marched_films(problem, films, neighbour, watch);
  DescribedOrbit run = find_described_orbit(alone, films, guess, watch);
  if (!problem.search.with_multipliers) return run;
  const std::optional<FreeDecay> coarse =
      problem.search.multipliers_on_own_grid ? std::nullopt : coarse_decay(problem, films, run.orbit, watch);
  run.decay = decay_of(problem, films, run, coarse, watch);
  return run;
}

void find_coarse_orbit(const OrbitProblem& problem, const SearchWatch& watch, MPI_Comm comm, FoundOrbit& found) {
  if (found.coarse || !coarser(problem.numerics)) return;
  const auto [numerics, ratio] = slightly_coarser(problem.numerics);
  if ((numerics.ny + 1) / 2 < processes_in(comm)) return;
  OrbitProblem coarse = searched_briefly(problem);
  coarse.numerics = numerics;
  coarse.search.with_multipliers = false;
  try {
    const SharedDiscretisation films = discretise(comm, coarse);
    const std::unique_ptr<RunStore> store = store_within(watch.store, "slightly_coarser", films->grid());
    const OrbitGuess guess{found.own.orbit.start.motion, found.own.orbit.monodromy, {}};
    found.coarse = find_described_orbit(coarse, films, guess, on_coarser_grid(watch, store.get(), coarse.mesh));
    found.ratio = ratio;
  } catch (const SolveError& error) {
    watch.on_trouble(place_of(numerics) + error.what());
  }
}

}  // namespace gearfilm

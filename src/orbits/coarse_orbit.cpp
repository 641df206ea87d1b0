#include "orbits/coarse_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film/expected_errors.hpp"
#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"
#include "orbits/halving_check.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

const Tuned<double> out_of_phase(
    "search_out_of_phase", 1.0,
    "phase of a swing at the end of a mesh period that the error of coarse steps may bring");
// With fewer the damping is wrong by more than a twentieth, and steps halve.
const Tuned<double> steps_of_a_swing("search_steps_of_a_swing", 20,
                                     "steps of a free swing that coarse marches have at least");
const Tuned<double> left_by_the_fit("search_left_by_the_fit", 0.1, "part of the frequency's error that the fit leaves");
const Tuned<double> many_node_steps(
    "search_many_node_steps", 4e6,
    "nodes times steps of a mesh period from which the coarser grid begins on one coarser still");
const Tuned<int> enough_periods("search_enough_periods", 6, "periods of a coarse search after which the best will do");
const Tuned<int> brief_periods("search_brief_periods", 12, "periods of searches for error bars alone");
const Tuned<double> more_damping("search_more_damping", 3.0, "damping of a further start, over the expected one");
const Tuned<double> same_orbit("search_same_orbit", 0.1, "distance of the motions of one orbit on two grids");
const Tuned<double> well_known("search_well_known", 0.1, "error of a multiplier whose map serves a search");
const Tuned<double> noise_of_decay("search_noise_of_decay", 3.0, "Newton's tolerance for a decay, in that of the case");

/// That films of another grid, or of another motion, have before a period begins: oil passes most of the contact
/// in 1.5.
double time_to_lead(const MeshModel& mesh) { return std::min(1.5, mesh.path.mesh_period() / 7.0); }

/// The problem on the coarser grid, where its films have one.
std::optional<OrbitProblem> coarser_problem(const OrbitProblem& problem, Discretisation& films) {
  const std::optional<PairNumerics> numerics = coarser(problem.numerics);
  if (!numerics || !films.prepare_coarser()) return {};
  OrbitProblem coarse = problem;
  coarse.numerics = *numerics;
  // A start and an estimate of errors: both far coarser than that.
  coarse.search.options.tolerance *= 10.0;
  coarse.search.options.film_tolerance *= 10.0;
  // A warm film may go on changing at its exit, node by node, for ever.
  if (problem.mesh.traction && problem.mesh.traction->heats_film()) coarse.search.options.film_tolerance = HUGE_VAL;
  coarse.numerics.steps.newton.tolerance *= 10.0;
  coarse.search.with_multipliers = false;
  coarse.search.options.lead = time_to_lead(problem.mesh);
  coarse.search.options.enough_periods = enough_periods;
  return coarse;
}

/// What the coarser grid has wrong is added to the error of the larger multiplier: films damp, and their damping is
/// taken to be off by as much as their thickness.
void add_grid_error(const OrbitProblem& coarse, FreeDecay& decay) {
  const double modulus = largest_modulus(decay.multipliers);
  const FilmErrors films =
      expected_errors(coarse.numerics.discretisation, ExpectedFilm(coarse.mesh.scales), steps_of(coarse.numerics));
  decay.modulus_error = std::hypot(decay.modulus_error, modulus * std::log(modulus) * films.central);
}

/// For error bars alone.
OrbitProblem searched_briefly(OrbitProblem problem) {
  int& most = problem.search.options.max_periods;
  most = std::min(most, brief_periods * problem.mesh.periods());
  return problem;
}

/// What watches marches that only lead to the orbit.
SearchWatch on_the_way(const SearchWatch& watch, RunStore* store) {
  return {.on_period = watch.on_coarse_period,
          .on_coarse_period = watch.on_coarse_period,
          .on_trouble = watch.on_trouble,
          .check_stop = watch.check_stop,
          .store = store};
}

/// What watches a search on a coarser grid, which is given up where too many of its steps are halved.
SearchWatch on_coarser_grid(const SearchWatch& watch, RunStore* store, const MeshModel& mesh) {
  SearchWatch own = on_the_way(watch, store);
  own.on_step = halving_check(mesh);
  return own;
}

OrbitGuess guess_from(const DescribedOrbit& run) {
  const PeriodicOrbit& orbit = run.orbit;
  const bool told = run.decay && run.decay->modulus_error < well_known;
  return {orbit.end.motion, told ? run.decay->map : orbit.monodromy, orbit.end};
}

/// Its steps tell the orbit, and how it damps.
bool resolves_swings(const OrbitProblem& problem) {
  const MeshModel& mesh = problem.mesh;
  return mesh.inertia == 0.0 || mesh.frequency() * problem.numerics.steps.dT * steps_of_a_swing < 1.0;
}

/// A pair that swings often in a mesh period ends it elsewhere with steps that are too long. Formulas of second order
/// have the frequency w wrong by (w dT)^2/3 of it, most of which the fit of frequencies takes away.
bool keeps_phase(const OrbitProblem& problem) {
  const MeshModel& mesh = problem.mesh;
  const double dT = problem.numerics.steps.dT;
  if (mesh.inertia == 0.0) return true;
  const double w = 2.0 * std::numbers::pi * mesh.frequency();
  return left_by_the_fit * w * mesh.period() * w * w * dT * dT / 3.0 < out_of_phase;
}

/// Words before what is said of a march there.
std::string place_of(const PairNumerics& numerics) {
  return worded("on ", numerics.nx, " x ", numerics.ny, " nodes with dT = ", numerics.steps.dT, ": ");
}

/// The orbits on the coarser grid, one from the other.
class CoarseSearch {
public:
  CoarseSearch(const OrbitProblem& coarse, const OrbitProblem& fine, const SearchWatch& watch, MPI_Comm comm)
      : twice_the_step_(coarse),
        own_step_(coarse),
        watch_(watch),
        doubles_the_step_(resolves_swings(coarse) && keeps_phase(coarse)),
        with_multipliers_(fine.search.with_multipliers),
        newton_of_decay_(fine.numerics.steps.newton),
        films_(discretise(comm, coarse)) {
    newton_of_decay_.tolerance *= noise_of_decay;
    own_step_.numerics.steps = fine.numerics.steps;
    own_step_.numerics.steps.newton = coarse.numerics.steps.newton;
  }

  /// With which a search begins: with twice the step, where the pair stays in phase and films follow it.
  const OrbitProblem& problem() const { return doubles_the_step_ ? twice_the_step_ : own_step_; }
  const SharedDiscretisation& films() const { return films_; }

  /// Nothing, and the reason to the watch, where its films cannot be solved; the name is that of its checkpoint.
  /// Throws NoPeriodicState.
  std::optional<DescribedOrbit> orbit(const std::string& name, const std::function<OrbitGuess()>& guess) {
    return orbit(name, problem(), guess);
  }

  /// An orbit with its decay, where multipliers are asked for.
  DescribedOrbit with_decay(DescribedOrbit run) {
    if (!with_multipliers_) return run;
    OrbitProblem coarse = problem();
    coarse.numerics.steps.newton = newton_of_decay_;
    run.decay = attempt<FreeDecay>("coarse_decay", coarse,
                                   [&](const SearchWatch& own) { return decay_from(coarse, films_, run, own); });
    if (run.decay) add_grid_error(coarse, *run.decay);
    return run;
  }

  bool has_twice_the_step() const { return doubles_the_step_; }
  /// Whether a search there was given up for its halved steps.
  bool has_too_many_halved() const { return too_many_halved_; }
  /// What an orbit with the step of the case itself has with a longer one. Nothing where it has none that is found
  /// about as soon.
  std::optional<DescribedOrbit> with_longer_step(const DescribedOrbit& found) {
    OrbitProblem brief = searched_briefly(own_step_);
    brief.numerics.steps.lengthen(FoundOrbit::step_ratio);
    try {
      return orbit("coarse_step", brief, [&] { return guess_from(found); });
    } catch (const NoPeriodicState& error) {
      watch_.on_trouble(error.what());
      return {};
    }
  }

private:
  std::optional<DescribedOrbit> orbit(const std::string& name, const OrbitProblem& coarse,
                                      const std::function<OrbitGuess()>& guess) {
    return attempt<DescribedOrbit>(
        name, coarse, [&](const SearchWatch& own) { return find_described_orbit(coarse, films_, guess(), own); });
  }

  template <class Result, class March>
  std::optional<Result> attempt(const std::string& name, const OrbitProblem& coarse, March march) {
    const std::string place = place_of(coarse.numerics);
    const std::unique_ptr<RunStore> store = store_within(watch_.store, name, films_->grid());
    try {
      return march(on_coarser_grid(watch_, store.get(), coarse.mesh));
    } catch (const NoPeriodicState& error) {
      throw NoPeriodicState(place + error.what());
    } catch (const TooManyHalved& error) {
      too_many_halved_ = true;
      watch_.on_trouble(place + error.what());
      return {};
    } catch (const SolveError& error) {
      watch_.on_trouble(place + error.what());
      return {};
    }
  }

  OrbitProblem twice_the_step_;
  OrbitProblem own_step_;
  const SearchWatch& watch_;
  bool doubles_the_step_;
  bool with_multipliers_;
  bool too_many_halved_ = false;
  NewtonOptions newton_of_decay_;
  SharedDiscretisation films_;
};

double pitch_displacement(const OrbitProblem& problem, const SharedDiscretisation& films) {
  return pitch_film(problem.mesh.scales, problem.numerics, films).solution.H0;
}

/// By how much the pair lies higher on the films of the problem's own grid: as much as one contact at rest does.
double film_shift(const CoarseSearch& coarse, const OrbitProblem& problem, const SharedDiscretisation& films) {
  try {
    return pitch_displacement(problem, films) - pitch_displacement(coarse.problem(), coarse.films());
  } catch (const SolveError&) {
    return 0.0;
  }
}

/// The orbit of the coarser grid as a guess on the problem's own: pressures interpolated, the bodies moved apart by as
/// much as its films are thicker.
OrbitGuess guess_on_grid(const OrbitProblem& problem, const SharedDiscretisation& films, const CoarseSearch& search,
                         const DescribedOrbit& coarse) {
  OrbitGuess guess = guess_from(coarse);
  const double shift = film_shift(search, problem, films);
  guess.motion.H0() += shift;
  guess.neighbour = refined(*coarse.orbit.before, films->grid().comm());
  guess.neighbour->motion.H0() += shift;
  guess.lead = search.problem().search.options.lead;
  if (coarse.decay) guess.lead_map = coarse.decay->lead_map;
  return guess;
}

/// The failure of the problem's own grid, and that the coarser one may serve.
SolveError with_remedy(const SolveError& failure, const PairNumerics& coarse) {
  return SolveError(failure.what(), "; on ", coarse.nx, " x ", coarse.ny,
                    " nodes (grid_nx, grid_ny) a periodic state was found, with the errors of that grid");
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
      const std::optional<DescribedOrbit> found =
          first.orbit("coarsest", [&] { return first_guess(*coarser, first.films(), dry); });
      if (found) return guess_on_grid(problem, search.films(), first, *found);
    } catch (const NoPeriodicState& error) {
      watch.on_trouble(error.what());
    }
  }
  return first_guess(problem, search.films(), dry);
}

/// From the dry orbit given, or else from one that is damped less or more; nothing where none leads to one.
std::optional<DescribedOrbit> first_coarse_orbit(CoarseSearch& search, const DryOrbit& dry, const SearchWatch& watch) {
  const auto found_from = [&](const std::string& name, const DryOrbit& start) -> std::optional<DescribedOrbit> {
    try {
      return search.orbit(name, [&] { return first_coarse_guess(search, start, watch); });
    } catch (const NoPeriodicState& error) {
      watch.on_trouble(error.what());
      return {};
    }
  };
  if (std::optional<DescribedOrbit> found = found_from("coarse", dry)) return found;
  const MeshModel& mesh = search.problem().mesh;
  if (mesh.inertia == 0.0 || search.has_too_many_halved()) return {};
  const double expected = expected_film_damping(mesh);
  const auto found_at_damping = [&](const std::string& name, double damping) {
    const std::optional<DryOrbit> start = find_dry_orbit_soon(mesh, damping);
    return start ? found_from(name, *start) : std::nullopt;
  };
  if (expected > typical_film_damping) {
    if (std::optional<DescribedOrbit> found = found_at_damping("coarse_less_damped", typical_film_damping))
      return found;
  }
  return found_at_damping("coarse_more_damped", more_damping * expected);
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
      if (!search.has_twice_the_step()) found.longer_step = search.with_longer_step(*first);
      if (search.has_twice_the_step() || found.longer_step) found.coarse = first;
      nearest = search.with_decay(*first);
      guess = guess_on_grid(problem, films, search, *nearest);
    }
  }
  if (!guess) guess = first_guess(problem, films, dry);
  const bool decay_known = nearest && nearest->decay;
  OrbitProblem last = problem;
  if (decay_known) last.search.with_multipliers = false;
  try {
    found.own = find_described_orbit(last, films, *guess, watch);
  } catch (const SolveError& error) {
    if (nearest) throw with_remedy(error, coarse->numerics);
    throw;
  }
  if (decay_known) found.own.decay = nearest->decay;
  return found;
}

DescribedOrbit find_orbit_with_coarse_start(const OrbitProblem& problem, const SharedDiscretisation& films,
                                            const OrbitGuess& neighbour, const SearchWatch& watch) {
  OrbitProblem alone = problem;
  alone.search.with_multipliers = false;
  const OrbitGuess guess = with_marched_films(problem, films, neighbour, watch);
  DescribedOrbit run = find_described_orbit(alone, films, guess, watch);
  if (!problem.search.with_multipliers) return run;
  run.decay = coarse_decay(problem, films, run.orbit, watch);
  if (run.decay) return run;
  const std::unique_ptr<RunStore> store = store_within(watch.store, "decay", films->grid());
  run.decay = decay_from(problem, films, run, on_the_way(watch, store.get()));
  return run;
}

void find_coarse_orbit(const OrbitProblem& problem, const SearchWatch& watch, MPI_Comm comm, FoundOrbit& found) {
  if (found.coarse || !coarser(problem.numerics)) return;
  const auto [numerics, ratio] = slightly_coarser(problem.numerics);
  if ((numerics.ny + 1) / 2 < processes_in(comm)) return;
  OrbitProblem coarse = searched_briefly(problem);
  coarse.numerics = numerics;
  coarse.search.with_multipliers = false;
  coarse.search.options.enough_periods = enough_periods;
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

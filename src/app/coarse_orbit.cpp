#include "app/coarse_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"
#include "gearfilm/film/expected_errors.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "input/case_numerics.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr double out_of_phase = 1.0;     // of a pair at the end of a mesh period, by the error of its steps
constexpr double steps_of_a_swing = 20;  // with fewer the damping is wrong by more than a twentieth, and steps halve
constexpr double left_by_the_fit = 0.1;  // of the frequency's error: stiffness changes within a step
constexpr double many_node_steps = 4e6;  // in a mesh period of the coarser grid
constexpr int enough_periods = 6;        // of a search: marches that scatter need not repeat as they should
constexpr int brief_periods = 12;        // of one that error bars alone are worth
constexpr double more_damping = 3.0;     // of a search, over what films are expected to give, where that finds nothing
constexpr double same_orbit = 0.1;       // between the motions of an orbit on two grids
constexpr double well_known = 0.1;       // error of a multiplier whose map serves a search
constexpr double noise_of_decay = 3.0;   // Newton's tolerance for a decay, in that of the case: its errors hardly grow

/// That films of another grid, or of another motion, have before a period begins: oil passes most of the contact
/// in 1.5.
double time_to_lead(const MeshModel& mesh) { return std::min(1.5, mesh.path.mesh_period() / 7.0); }

/// The case on the coarser grid, where its films have one.
std::optional<Case> coarser_case(const Case& problem, const MeshModel& mesh, Discretisation& films) {
  const std::optional<NumericsCase> numerics = coarser(problem.numerics);
  if (!numerics || !films.prepare_coarser()) return {};
  Case coarse = problem;
  coarse.numerics = *numerics;
  // A start and an estimate of errors: both far coarser than that.
  coarse.search.options.tolerance *= 10.0;
  coarse.search.options.film_tolerance *= 10.0;
  // A warm film may go on changing at its exit, node by node, for ever.
  if (problem.traction && problem.traction->heats_film()) coarse.search.options.film_tolerance = HUGE_VAL;
  coarse.numerics.steps.newton.tolerance *= 10.0;
  coarse.search.with_multipliers = false;
  coarse.search.options.lead = time_to_lead(mesh);
  coarse.search.options.enough_periods = enough_periods;
  return coarse;
}

/// What the coarser grid has wrong is added to the error of the larger multiplier: films damp, and their damping is
/// taken to be off by as much as their thickness.
void add_grid_error(const Case& coarse, FreeDecay& decay) {
  const double modulus = largest_modulus(decay.multipliers);
  const FilmErrors films =
      expected_errors(coarse.numerics.discretisation, ExpectedFilm(coarse.scales), steps_of(coarse.numerics));
  decay.modulus_error = std::hypot(decay.modulus_error, modulus * std::log(modulus) * films.central);
}

/// For error bars alone.
Case searched_briefly(Case problem, const MeshModel& mesh) {
  int& most = problem.search.options.max_periods;
  most = std::min(most, brief_periods * mesh.periods());
  return problem;
}

/// What watches marches that only lead to the orbit.
OrbitObservers on_the_way(const OrbitObservers& observers, Checkpoint& checkpoint) {
  return {.on_period = observers.on_coarse_period,
          .on_coarse_period = observers.on_coarse_period,
          .on_trouble = observers.on_trouble,
          .checkpoint = checkpoint,
          .stop = observers.stop};
}

OrbitGuess guess_from(const OrbitRun& run) {
  const PeriodicOrbit& orbit = run.orbit;
  const bool told = run.decay && run.decay->modulus_error < well_known;
  return {orbit.end.motion, told ? run.decay->map : orbit.monodromy, orbit.end};
}

/// Steps of dT tell the orbit, and how it damps.
bool resolves_swings(const MeshModel& mesh, double dT) {
  return mesh.inertia == 0.0 || mesh.frequency() * dT * steps_of_a_swing < 1.0;
}

/// A pair that swings often in a mesh period ends it elsewhere with steps that are too long. Formulas of second order
/// have the frequency w wrong by (w dT)^2/3 of it, most of which the fit of frequencies takes away.
bool keeps_phase(const MeshModel& mesh, double dT) {
  if (mesh.inertia == 0.0) return true;
  const double w = 2.0 * std::numbers::pi * mesh.frequency();
  return left_by_the_fit * w * mesh.period() * w * w * dT * dT / 3.0 < out_of_phase;
}

/// Words before what is said of a march there.
std::string place_of(const NumericsCase& numerics) {
  return "on " + std::to_string(numerics.nx) + " x " + std::to_string(numerics.ny) +
         " nodes with dT = " + format_value(numerics.steps.dT) + ": ";
}

/// The orbits on the coarser grid, one from the other.
class CoarseSearch {
public:
  CoarseSearch(const Case& coarse, const Case& fine, const MeshModel& mesh, const OrbitObservers& observers,
               MPI_Comm comm)
      : twice_the_step_(coarse),
        own_step_(coarse),
        mesh_(mesh),
        observers_(observers),
        in_phase_(resolves_swings(mesh, coarse.numerics.steps.dT) && keeps_phase(mesh, coarse.numerics.steps.dT)),
        with_multipliers_(fine.search.with_multipliers),
        newton_of_decay_(fine.numerics.steps.newton),
        films_(discretise(comm, coarse)) {
    newton_of_decay_.tolerance *= noise_of_decay;
    own_step_.numerics.steps = fine.numerics.steps;
    own_step_.numerics.steps.newton = coarse.numerics.steps.newton;
  }

  /// With which a search begins: with twice the step, where the pair stays in phase.
  const Case& problem() const { return in_phase_ ? twice_the_step_ : own_step_; }
  const SharedDiscretisation& films() const { return films_; }

  /// Nothing, and the reason to the observers, where its films cannot be solved; the name is that of its checkpoint.
  /// Throws NoPeriodicState.
  std::optional<OrbitRun> orbit(const std::string& name, const std::function<OrbitGuess()>& guess) {
    return orbit(name, problem(), guess);
  }

  /// An orbit with its decay, where multipliers are asked for.
  OrbitRun with_decay(OrbitRun run) {
    if (!with_multipliers_) return run;
    Case coarse = problem();
    coarse.numerics.steps.newton = newton_of_decay_;
    run.decay = attempt<FreeDecay>(
        "coarse_decay", coarse, [&](const OrbitObservers& own) { return decay_from(coarse, films_, mesh_, run, own); });
    if (run.decay) add_grid_error(coarse, *run.decay);
    return run;
  }

  bool has_twice_the_step() const { return in_phase_; }
  /// What an orbit with the step of the case itself has with a longer one. Nothing where it has none that is found
  /// about as soon.
  std::optional<OrbitRun> with_longer_step(const OrbitRun& found) {
    Case brief = searched_briefly(own_step_, mesh_);
    brief.numerics.steps.lengthen(FoundOrbit::step_ratio);
    try {
      return orbit("coarse_step", brief, [&] { return guess_from(found); });
    } catch (const NoPeriodicState& error) {
      observers_.on_trouble(error.what());
      return {};
    }
  }

private:
  std::optional<OrbitRun> orbit(const std::string& name, const Case& coarse, const std::function<OrbitGuess()>& guess) {
    return attempt<OrbitRun>(name, coarse,
                             [&](const OrbitObservers& own) { return run_orbit(coarse, films_, mesh_, guess(), own); });
  }

  template <class Result, class March>
  std::optional<Result> attempt(const std::string& name, const Case& coarse, March march) {
    const std::string place = place_of(coarse.numerics);
    Checkpoint checkpoint = observers_.checkpoint.within(name, films_->grid());
    try {
      return march(on_the_way(observers_, checkpoint));
    } catch (const NoPeriodicState& error) {
      throw NoPeriodicState(place + error.what());
    } catch (const SolveError& error) {
      observers_.on_trouble(place + error.what());
      return {};
    }
  }

  Case twice_the_step_;
  Case own_step_;
  const MeshModel& mesh_;
  const OrbitObservers& observers_;
  bool in_phase_;
  bool with_multipliers_;
  NewtonOptions newton_of_decay_;
  SharedDiscretisation films_;
};

/// By how much the pair lies higher on the films of the case's own grid: as much as one contact at rest does.
double film_shift(const CoarseSearch& coarse, const Case& problem, const SharedDiscretisation& films) {
  try {
    return pitch_film(problem, films).solution.H0 - pitch_film(coarse.problem(), coarse.films()).solution.H0;
  } catch (const SolveError&) {
    return 0.0;
  }
}

/// The orbit of the coarser grid as a guess on the case's own: pressures interpolated, the bodies moved apart by as
/// much as its films are thicker.
OrbitGuess guess_on_grid(const Case& problem, const SharedDiscretisation& films, const CoarseSearch& search,
                         const OrbitRun& coarse) {
  OrbitGuess guess = guess_from(coarse);
  const double shift = film_shift(search, problem, films);
  guess.motion.H0() += shift;
  guess.neighbour = refined(*coarse.orbit.before, films->grid().comm());
  guess.neighbour->motion.H0() += shift;
  guess.lead = search.problem().search.options.lead;
  if (coarse.decay) guess.lead_map = coarse.decay->lead_map;
  return guess;
}

/// The failure of the case's own grid, and that the coarser one may serve.
SolveError with_remedy(const SolveError& failure, const NumericsCase& coarse) {
  return SolveError(failure.what(), "; on ", coarse.nx, " x ", coarse.ny,
                    " nodes (grid_nx, grid_ny) a periodic state was found, with the errors of that grid");
}

/// Where the search on the coarser grid begins: where a mesh period is long even there, on the orbit of one that is
/// coarser still, with its step and its tolerances; else on the dry pair's.
OrbitGuess first_coarse_guess(const CoarseSearch& search, const MeshModel& mesh, const DryOrbit& dry,
                              const OrbitObservers& observers) {
  const Case& problem = search.problem();
  const double steps = mesh.period() / problem.numerics.steps.dT;
  std::optional<Case> coarser = coarser_case(problem, mesh, *search.films());
  if (coarser && steps * problem.numerics.nx * problem.numerics.ny > many_node_steps) {
    coarser->search.options = problem.search.options;
    coarser->numerics.steps = problem.numerics.steps;
    CoarseSearch first(*coarser, problem, mesh, observers, search.films()->grid().comm());
    try {
      const std::optional<OrbitRun> found =
          first.orbit("coarsest", [&] { return first_guess(*coarser, first.films(), dry); });
      if (found) return guess_on_grid(problem, search.films(), first, *found);
    } catch (const NoPeriodicState& error) {
      observers.on_trouble(error.what());
    }
  }
  return first_guess(problem, search.films(), dry);
}

/// From the dry orbit given, or else from one that is damped less or more; nothing where none leads to one.
std::optional<OrbitRun> first_coarse_orbit(CoarseSearch& search, const MeshModel& mesh, const DryOrbit& dry,
                                           const OrbitObservers& observers) {
  const auto found_from = [&](const std::string& name, const DryOrbit& start) -> std::optional<OrbitRun> {
    try {
      return search.orbit(name, [&] { return first_coarse_guess(search, mesh, start, observers); });
    } catch (const NoPeriodicState& error) {
      observers.on_trouble(error.what());
      return {};
    }
  };
  if (std::optional<OrbitRun> found = found_from("coarse", dry)) return found;
  if (mesh.inertia == 0.0) return {};
  const double expected = expected_film_damping(mesh);
  const auto found_at_damping = [&](const std::string& name, double damping) {
    const std::optional<DryOrbit> start = find_dry_orbit_soon(mesh, damping);
    return start ? found_from(name, *start) : std::nullopt;
  };
  if (expected > typical_film_damping) {
    if (std::optional<OrbitRun> found = found_at_damping("coarse_less_damped", typical_film_damping)) return found;
  }
  return found_at_damping("coarse_more_damped", more_damping * expected);
}

/// The guess after a period with twice the step, where that resolves the swings: films of another case need a march to
/// become those of this one.
OrbitGuess with_marched_films(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                              const OrbitGuess& guess, const OrbitObservers& observers) {
  Case quick = problem;
  quick.numerics.steps.lengthen(2.0);
  if (!guess.neighbour || !resolves_swings(mesh, quick.numerics.steps.dT)) return guess;
  Checkpoint checkpoint = observers.checkpoint.within("coarse_step", films->grid());
  try {
    return improve_guess(quick, films, mesh, guess, on_the_way(observers, checkpoint));
  } catch (const SolveError&) {
    return guess;
  }
}

/// The return of the pair to the orbit next to this one on the coarser grid; nothing where it has none.
std::optional<FreeDecay> coarse_decay(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                                      const PeriodicOrbit& orbit, const OrbitObservers& observers) {
  const std::optional<Case> coarse = coarser_case(problem, mesh, *films);
  if (!coarse) return {};
  CoarseSearch search(*coarse, problem, mesh, observers, films->grid().comm());
  OrbitGuess guess{orbit.start.motion, orbit.monodromy, {}};
  guess.motion.H0() -= film_shift(search, problem, films);
  try {
    const std::optional<OrbitRun> found = search.orbit("coarse", [&] { return guess; });
    if (!found || mesh.weighted_norm(difference(found->orbit.start.motion, guess.motion)) > same_orbit) return {};
    return search.with_decay(*found).decay;
  } catch (const SolveError&) {
    return {};
  }
}

}  // namespace

FoundOrbit find_orbit(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                      const DryOrbit& dry, const OrbitObservers& observers) {
  FoundOrbit found{.discretisation = problem.numerics.discretisation};
  std::optional<OrbitGuess> guess;
  std::optional<OrbitRun> nearest;
  const std::optional<Case> coarse = coarser_case(problem, mesh, *films);
  if (coarse) {
    CoarseSearch search(*coarse, problem, mesh, observers, films->grid().comm());
    const std::optional<OrbitRun> first = first_coarse_orbit(search, mesh, dry, observers);
    if (first) {
      if (!search.has_twice_the_step()) found.longer_step = search.with_longer_step(*first);
      if (search.has_twice_the_step() || found.longer_step) found.coarse = first;
      nearest = search.with_decay(*first);
      guess = guess_on_grid(problem, films, search, *nearest);
    }
  }
  if (!guess) guess = first_guess(problem, films, dry);
  const bool decay_known = nearest && nearest->decay;
  Case last = problem;
  if (decay_known) last.search.with_multipliers = false;
  try {
    found.run = run_orbit(last, films, mesh, *guess, observers);
  } catch (const SolveError& error) {
    if (nearest) throw with_remedy(error, coarse->numerics);
    throw;
  }
  if (decay_known) found.run.decay = nearest->decay;
  return found;
}

OrbitRun find_orbit_near(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                         const OrbitGuess& neighbour, const OrbitObservers& observers) {
  Case alone = problem;
  alone.search.with_multipliers = false;
  const OrbitGuess guess = with_marched_films(problem, films, mesh, neighbour, observers);
  OrbitRun run = run_orbit(alone, films, mesh, guess, observers);
  if (!problem.search.with_multipliers) return run;
  run.decay = coarse_decay(problem, films, mesh, run.orbit, observers);
  if (run.decay) return run;
  Checkpoint checkpoint = observers.checkpoint.within("decay", films->grid());
  run.decay = decay_from(problem, films, mesh, run, on_the_way(observers, checkpoint));
  return run;
}

void find_coarse_orbit(const Case& problem, const MeshModel& mesh, const OrbitObservers& observers, MPI_Comm comm,
                       FoundOrbit& found) {
  if (found.coarse || !coarser(problem.numerics)) return;
  const auto [numerics, ratio] = slightly_coarser(problem.numerics);
  if ((numerics.ny + 1) / 2 < processes_in(comm)) return;
  Case coarse = searched_briefly(problem, mesh);
  coarse.numerics = numerics;
  coarse.search.with_multipliers = false;
  coarse.search.options.enough_periods = enough_periods;
  try {
    const SharedDiscretisation films = discretise(comm, coarse);
    Checkpoint checkpoint = observers.checkpoint.within("slightly_coarser", films->grid());
    const OrbitGuess guess{found.run.orbit.start.motion, found.run.orbit.monodromy, {}};
    found.coarse = run_orbit(coarse, films, mesh, guess, on_the_way(observers, checkpoint));
    found.ratio = ratio;
  } catch (const SolveError& error) {
    observers.on_trouble(place_of(numerics) + error.what());
  }
}

}  // namespace gearfilm

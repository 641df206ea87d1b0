#include "orbits/coarse_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grid/domain.hpp"
#include "numerics/tuned.hpp"
#include "orbits/halving_check.hpp"
#include "orbits/multiplier_error.hpp"

namespace gearfilm {
namespace {

const Tuned<double> out_of_phase(
    "search_out_of_phase", 1.0,
    "phase of a swing at the end of a mesh period that the error of coarse steps may bring");
// With fewer the damping is wrong by more than a twentieth, and steps halve.
const Tuned<double> steps_of_a_swing("search_steps_of_a_swing", 20,
                                     "steps of a free swing that coarse marches have at least");
const Tuned<double> left_by_the_fit("search_left_by_the_fit", 0.1, "part of the frequency's error that the fit leaves");
const Tuned<int> enough_periods("search_enough_periods", 6, "periods of a coarse search after which the best will do");
const Tuned<int> brief_periods("search_brief_periods", 12, "periods of searches for error bars alone");
const Tuned<double> well_known("search_well_known", 0.1, "error of a multiplier whose map serves a search");
const Tuned<double> noise_of_decay("search_noise_of_decay", 3.0, "Newton's tolerance for a decay, in that of the case");

/// That films of another grid, or of another motion, have before a period begins: oil passes most of the contact
/// in 1.5, in thick oil of the length over which pressure changes.
double time_to_lead(const MeshModel& mesh) {
  return std::min(1.5 * pressure_length(ExpectedFilm(mesh.scales)), mesh.path.mesh_period() / 7.0);
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

}  // namespace

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

OrbitProblem searched_briefly(OrbitProblem problem) {
  int& most = problem.search.options.max_periods;
  most = std::min(most, brief_periods * problem.mesh.periods());
  problem.search.options.enough_periods = enough_periods;
  return problem;
}

SearchWatch on_the_way(const SearchWatch& watch, RunStore* store) {
  return {.on_period = watch.on_coarse_period,
          .on_coarse_period = watch.on_coarse_period,
          .on_trouble = watch.on_trouble,
          .check_stop = watch.check_stop,
          .store = store};
}

SearchWatch on_coarser_grid(const SearchWatch& watch, RunStore* store, const MeshModel& mesh) {
  SearchWatch own = on_the_way(watch, store);
  own.on_step = halving_check(mesh);
  return own;
}

bool resolves_swings(const OrbitProblem& problem) {
  const MeshModel& mesh = problem.mesh;
  return mesh.inertia == 0.0 || mesh.frequency() * problem.numerics.steps.dT * steps_of_a_swing < 1.0;
}

std::string place_of(const PairNumerics& numerics) {
  return worded("on ", numerics.nx, " x ", numerics.ny, " nodes with dT = ", numerics.steps.dT, ": ");
}

CoarseSearch::CoarseSearch(const OrbitProblem& coarse, const OrbitProblem& fine, const SearchWatch& watch,
                           MPI_Comm comm)
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

const FilmSolution& CoarseSearch::pitch_film() const {
  const OrbitProblem& own = problem();
  if (!pitch_film_) pitch_film_ = gearfilm::pitch_film(own.mesh.scales, own.numerics, films_).solution;
  return *pitch_film_;
}

template <class Result, class March>
std::optional<Result> CoarseSearch::attempt(const std::string& name, const OrbitProblem& coarse, March march) {
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

std::optional<DescribedOrbit> CoarseSearch::orbit_of(const std::string& name, const OrbitProblem& coarse,
                                                     const std::function<OrbitGuess()>& guess) {
  return attempt<DescribedOrbit>(
      name, coarse, [&](const SearchWatch& own) { return find_described_orbit(coarse, films_, guess(), own); });
}

std::optional<DescribedOrbit> CoarseSearch::orbit(const std::string& name, const std::function<OrbitGuess()>& guess,
                                                  std::optional<int> patience) {
  OrbitProblem coarse = problem();
  coarse.search.options.patience = patience;
  return orbit_of(name, coarse, guess);
}

std::optional<DescribedOrbit> CoarseSearch::with_longer_step(const DescribedOrbit& found, double ratio) {
  OrbitProblem brief = searched_briefly(own_step_);
  brief.numerics.steps.lengthen(ratio);
  try {
    return orbit_of("coarse_step", brief, [&] { return guess_from(found); });
  } catch (const NoPeriodicState& error) {
    watch_.on_trouble(error.what());
    return {};
  }
}

DescribedOrbit CoarseSearch::with_decay(DescribedOrbit run) {
  if (!with_multipliers_) return run;
  OrbitProblem coarse = problem();
  coarse.numerics.steps.newton = newton_of_decay_;
  run.decay = attempt<FreeDecay>("coarse_decay", coarse,
                                 [&](const SearchWatch& own) { return decay_from(coarse, films_, run, own); });
  return run;
}

OrbitGuess CoarseSearch::guess_from(const DescribedOrbit& run) const {
  OrbitGuess guess{run.orbit.end.motion, run.orbit.monodromy, run.orbit.end};
  if (!run.decay) return guess;
  // Damping as wrong as the central film would be: what the map has wrong besides, the search finds out. In the short
  // lead damping does little.
  const double modulus = largest_modulus(run.decay->multipliers);
  const double of_damping = modulus * std::log(modulus) * film_errors(problem()).central;
  if (std::hypot(run.decay->fit_error, of_damping) < well_known) guess.monodromy = run.decay->map;
  if (run.decay->fit_error < well_known) guess.lead_map = run.decay->lead_map;
  return guess;
}

double film_shift(const CoarseSearch& coarse, const OrbitProblem& problem, const SharedDiscretisation& films) {
  try {
    const FilmSolution& film = coarse.pitch_film();
    const ContactFields fields{{std::string(field::pressure.name), film.pressure}};
    const PairState fine = refined({{}, {fields}, coarse.films()->grid().shape()}, films->grid().comm(),
                                   coarsened_along(problem.numerics));
    const FilmSolution guess{values_of(fine.films.front(), field::pressure), film.H0};
    return pitch_film(problem.mesh.scales, problem.numerics, films, &guess).solution.H0 - film.H0;
  } catch (const SolveError&) {
    return 0.0;
  }
}

OrbitGuess guess_on_grid(const OrbitProblem& problem, const SharedDiscretisation& films, const CoarseSearch& search,
                         const DescribedOrbit& coarse) {
  OrbitGuess guess = search.guess_from(coarse);
  const double shift = film_shift(search, problem, films);
  guess.motion.H0() += shift;
  guess.neighbour = refined(*coarse.orbit.before, films->grid().comm(), coarsened_along(problem.numerics));
  guess.neighbour->motion.H0() += shift;
  guess.lead = search.problem().search.options.lead;
  return guess;
}

}  // namespace gearfilm

#include "gearfilm/app/coarse_orbit.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/ehl/domain.hpp"
#include "gearfilm/ehl/grid_error.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_numerics.hpp"
#include "gearfilm/input/case_setup.hpp"

namespace gearfilm {
namespace {

constexpr double most_in_phase = 12.0;  // swings in a mesh period after which twice the step is still in phase
constexpr double well_known = 0.1;      // error of a multiplier whose map serves a search

/// The case on the coarser grid, where its films have one.
std::optional<Case> coarser_case(const Case& problem, const Discretisation& films) {
  const std::optional<NumericsCase> numerics = coarser(problem.numerics);
  if (!numerics || !films.coarser()) return {};
  Case coarse = problem;
  coarse.numerics = *numerics;
  // A start and an estimate of errors: both far coarser than that.
  coarse.search.options.tolerance *= 10.0;
  coarse.search.options.film_tolerance *= 10.0;
  // A warm film may go on changing at its exit, node by node, for ever.
  if (problem.traction && problem.traction->heats_film()) coarse.search.options.film_tolerance = HUGE_VAL;
  coarse.numerics.steps.newton.tolerance *= 10.0;
  coarse.search.with_multipliers = false;
  return coarse;
}

/// What the coarser grid has wrong is added to the error of the larger multiplier: films damp, and their damping is
/// taken to be off by as much as their thickness.
void add_grid_error(const Case& coarse, FreeDecay& decay) {
  const double modulus = largest_modulus(decay.multipliers);
  const FilmErrors films = expected_errors(ExpectedFilm(coarse.scales), steps_of(coarse.numerics));
  decay.modulus_error = std::hypot(decay.modulus_error, modulus * std::log(modulus) * films.central);
}

/// The orbits on the coarser grid, one from the other.
class CoarseSearch {
public:
  CoarseSearch(const Case& coarse, const MeshModel& mesh, const OrbitObservers& observers, MPI_Comm comm)
      : mesh_(mesh),
        observers_(observers),
        films_(discretise(comm, coarse)),
        on_grid_("on " + std::to_string(coarse.numerics.nx) + " x " + std::to_string(coarse.numerics.ny) + " nodes") {}

  const SharedDiscretisation& films() const { return films_; }

  /// Nothing, and the reason to the observers, where its films cannot be solved. Throws NoPeriodicState.
  std::optional<OrbitRun> orbit(const std::string& name, const Case& coarse, const std::function<OrbitGuess()>& guess) {
    return attempt<OrbitRun>(name, coarse,
                             [&](const OrbitObservers& own) { return run_orbit(coarse, films_, mesh_, guess(), own); });
  }
  std::optional<FreeDecay> decay(const std::string& name, const Case& coarse, const PeriodicOrbit& orbit) {
    return attempt<FreeDecay>(name, coarse,
                              [&](const OrbitObservers& own) { return decay_from(coarse, films_, mesh_, orbit, own); });
  }

private:
  template <class Result, class March>
  std::optional<Result> attempt(const std::string& name, const Case& coarse, March march) {
    const std::string place = on_grid_ + " with dT = " + format_value(coarse.numerics.steps.dT) + ": ";
    Checkpoint checkpoint = observers_.checkpoint.within(name, films_->grid());
    const OrbitObservers own = {[](const StepRecord&, const std::vector<LiveContact>&) {},
                                observers_.on_coarse_period,
                                observers_.on_coarse_period,
                                observers_.on_trouble,
                                checkpoint,
                                observers_.stop};
    try {
      return march(own);
    } catch (const NoPeriodicState& error) {
      throw NoPeriodicState(place + error.what());
    } catch (const SolveError& error) {
      observers_.on_trouble(place + error.what());
      return {};
    }
  }

  const MeshModel& mesh_;
  const OrbitObservers& observers_;
  SharedDiscretisation films_;
  std::string on_grid_;
};

OrbitGuess guess_from(const OrbitRun& run) {
  const PeriodicOrbit& orbit = run.orbit;
  const bool told = run.decay && run.decay->modulus_error < well_known;
  return {orbit.end.motion, told ? run.decay->map : orbit.monodromy, orbit.end};
}

/// With stationary films at this motion.
PairState still_pair(const Case& problem, const GridShape& shape, const MeshModel& mesh, const Motion& motion,
                     MPI_Comm comm) {
  const SharedDiscretisation films = discretise(Grid(comm, shape), mesh.scales);
  MeshMarch march = make_march(
      problem, films, mesh, [](const StepRecord&, const std::vector<LiveContact>&) {}, nullptr);
  march.start(motion);
  return march.state();
}

/// A state of the coarser grid on the grid itself: interpolated, and corrected by what stationary films at the same
/// motion differ by.
PairState carried(const Case& coarse, const Case& fine, const MeshModel& mesh, const PairState& from, MPI_Comm comm) {
  PairState result = refined(from, comm);
  PairState before, after;
  try {
    before = refined(still_pair(coarse, from.shape, mesh, from.motion, comm), comm);
    after = still_pair(fine, result.shape, mesh, from.motion, comm);
  } catch (const SolveError&) {
    return result;
  }
  if (before.shape != result.shape || after.shape != result.shape) return result;
  for (std::size_t k = 0; k < result.films.size(); ++k) {
    const auto pressure = [k](const PairState& of) { return values_of(of.films[k], field::pressure); };
    const std::vector<double> coarsely = pressure(before), finely = pressure(after);
    std::vector<double>& values = values_of(result.films[k], field::pressure);
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = std::max(0.0, values[n] + finely[n] - coarsely[n]);
  }
  return result;
}

/// What depends on films, pressures or forces.
bool has_error(const PeriodFigure& figure) {
  const auto of = [&](const Unit& unit) { return figure.unit.name == unit.name && !figure.unit.whole; };
  return of(units::metre) || of(units::pascal) || figure.unit.in_si == units::static_force.in_si || of(units::watt);
}

}  // namespace

FoundOrbit find_orbit(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                      const DryOrbit& dry, const OrbitObservers& observers) {
  MPI_Comm comm = films->grid().comm();
  const std::optional<Case> coarse = coarser_case(problem, *films);
  FoundOrbit found;
  std::optional<OrbitRun> nearest;
  if (coarse) {
    CoarseSearch search(*coarse, mesh, observers, comm);
    found.coarse = search.orbit("coarse", *coarse, [&] { return first_guess(*coarse, search.films(), dry); });
    if (found.coarse) {
      Case own_step = *coarse;
      own_step.numerics.steps.dT = problem.numerics.steps.dT;
      nearest = search.orbit("coarse_grid", own_step, [&] {
        OrbitGuess guess = guess_from(*found.coarse);
        const double swings = mesh.frequency() * mesh.period();
        if (swings > most_in_phase) guess.monodromy = {};
        return guess;
      });
      own_step.numerics.steps.newton = problem.numerics.steps.newton;
      if (nearest && problem.search.with_multipliers) {
        nearest->decay = search.decay("coarse_decay", own_step, nearest->orbit);
        if (nearest->decay) add_grid_error(own_step, *nearest->decay);
      }
    }
  }
  Case last = problem;
  if (nearest && nearest->decay) last.search.with_multipliers = false;
  if (!nearest) nearest = found.coarse;
  OrbitGuess guess = nearest ? guess_from(*nearest) : first_guess(problem, films, dry);
  if (guess.neighbour) guess.neighbour = carried(*coarse, problem, mesh, *guess.neighbour, comm);
  found.run = run_orbit(last, films, mesh, guess, observers);
  if (!found.run.decay && nearest) found.run.decay = nearest->decay;
  return found;
}

std::optional<double> add_errors(const Scales& scales, const FoundOrbit& found, Summary& summary) {
  const auto& [run, coarse] = found;
  std::optional<double> largest;
  const auto add = [&](const std::string& name, double fine, std::optional<double> half) {
    Summary &error = summary[name + "_error"], &extrapolated = summary[name + "_extrapolated"];
    if (!half) return;  // null
    const Estimate estimated = estimate(fine, *half);
    error = estimated.error;
    extrapolated = estimated.extrapolated;
    largest = std::max(largest.value_or(0.0), estimated.relative_error());
  };
  for (std::size_t n = 0; n < period_figures.size(); ++n) {
    const PeriodFigure& figure = period_figures[n];
    const std::optional<double>& value = run.figures.values[n];
    if (!value || !has_error(figure)) continue;
    std::optional<double> half = coarse ? coarse->figures.values[n] : std::nullopt;
    if (half) half = figure.unit.in_si(scales, *half);
    add(std::string(figure.name), figure.unit.in_si(scales, *value), half);
  }
  const auto swing = [&](const OrbitRun& of) { return scales.thickness * of.transmission_error.peak_to_peak; };
  add("transmission_error_peak_to_peak", swing(run), coarse ? std::optional(swing(*coarse)) : std::nullopt);
  return largest;
}

}  // namespace gearfilm

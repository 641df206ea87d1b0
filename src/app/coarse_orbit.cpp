#include "gearfilm/app/coarse_orbit.hpp"

#include <algorithm>

#include "gearfilm/ehl/grid_error.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_numerics.hpp"
#include "gearfilm/input/case_setup.hpp"

namespace gearfilm {
namespace {

/// The case on the coarser grid, where its films have one.
std::optional<Case> coarser_case(const Case& problem, const Discretisation& films) {
  const std::optional<NumericsCase> numerics = coarser(problem.numerics);
  if (!numerics || !films.coarser()) return {};
  Case coarse = problem;
  coarse.numerics = *numerics;
  // A start and an estimate of errors: both far coarser than that.
  coarse.search.options.tolerance *= 10.0;
  coarse.search.options.film_tolerance *= 10.0;
  coarse.search.with_multipliers = false;
  return coarse;
}

OrbitRun find_coarse(const Case& problem, const MeshModel& mesh, const DryOrbit& dry, const OrbitObservers& observers,
                     MPI_Comm comm) {
  const SharedDiscretisation films = discretise(comm, problem);
  Checkpoint checkpoint = observers.checkpoint.within("coarse", films->grid());
  const OrbitObservers own = {[](const StepRecord&, const std::vector<LiveContact>&) {}, observers.on_coarse_period,
                              observers.on_coarse_period, checkpoint, observers.stop};
  return run_orbit(problem, films, mesh, dry_guess(problem, films, dry), own);
}

/// What depends on films, pressures or forces.
bool has_error(const PeriodFigure& figure) {
  const auto of = [&](const Unit& unit) { return figure.unit.name == unit.name && !figure.unit.whole; };
  return of(units::metre) || of(units::pascal) || figure.unit.in_si == units::static_force.in_si;
}

}  // namespace

OrbitStart orbit_start(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                       const DryOrbit& dry, const OrbitObservers& observers) {
  MPI_Comm comm = films->grid().comm();
  std::string trouble;
  if (const std::optional<Case> coarse = coarser_case(problem, *films)) {
    const auto on_grid = [&](const std::string& what) {
      return "on " + std::to_string(coarse->numerics.nx) + " x " + std::to_string(coarse->numerics.ny) +
             " nodes: " + what;
    };
    try {
      OrbitRun found = find_coarse(*coarse, mesh, dry, observers, comm);
      const PeriodicOrbit& orbit = found.orbit;
      return {{orbit.end.motion, orbit.monodromy, refined(orbit.end, comm)}, std::move(found), {}};
    } catch (const NoPeriodicState& error) {
      throw NoPeriodicState(on_grid(error.what()));
    } catch (const SolveError& error) {
      trouble = on_grid(error.what());
    }
  }
  return {dry_guess(problem, films, dry), {}, trouble};
}

std::optional<double> add_errors(const Scales& scales, const OrbitRun& run, const std::optional<OrbitRun>& coarse,
                                 Summary& summary) {
  std::optional<double> largest;
  const auto add = [&](const std::string& name, double fine, std::optional<double> half) {
    Summary &error = summary[name + "_error"], &extrapolated = summary[name + "_extrapolated"];
    if (!half) return;  // null
    const Estimate found = estimate(fine, *half);
    error = found.error;
    extrapolated = found.extrapolated;
    largest = std::max(largest.value_or(0.0), found.relative_error());
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

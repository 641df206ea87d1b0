#include "gearfilm/traction/thermal_film.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

#include "gearfilm/error.hpp"
#include "gearfilm/parallel/anderson_mixing.hpp"

namespace gearfilm {
namespace {

constexpr int most_turns = 100;
constexpr int most_newton = 15;  // iterations; a film that needs more has been moved too far
// A new F moves the rows of the inlet by more than all others together: a rough linear solution would not see these.
constexpr double krylov_tolerance = 1e-5;
constexpr double relaxation = 0.8;      // of the way to the new correction
constexpr int memory = 6;               // turns that are mixed
constexpr double near = 0.1;            // relative change of the film from which on they are
constexpr double largest_change = 1.0;  // of theta
constexpr double coldest = 150.0;       // that mixing may make a temperature [K]
constexpr double shortest_way = 1e-3;
// Turns after which a film that has not settled goes on without mixing, part of the way.
constexpr int patience = 30;
constexpr double careful_way = 0.25;

// Changes in a turn at which a film counts as settled.
constexpr double settled_film = 2e-4;        // relative
constexpr double settled_friction = 1e-3;    // relative
constexpr double settled_temperature = 0.5;  // [K]
constexpr double loaded = 5e-3;              // of the pressure scale

/// What a turn changed, over what it may.
struct Turn {
  double film = HUGE_VAL;
  double unrest = HUGE_VAL;
};

/// So many turns in a row that change no more than so many times that: on a coarse grid a film may go on moving a little,
/// where a node at its exit changes between wet and dry.
struct Rest {
  std::size_t turns;
  double unrest;
};
constexpr Rest at_rest[] = {{3, 1.0}, {10, 5.0}, {30, 25.0}};

/// The largest change of the film in the turns that make it settled; nothing where it is not.
std::optional<double> settled(const std::vector<Turn>& turns) {
  for (const Rest& rest : at_rest) {
    if (turns.size() < rest.turns) continue;
    const std::span last = std::span(turns).last(rest.turns);
    if (std::ranges::max(last, {}, &Turn::unrest).unrest > rest.unrest) continue;
    return std::ranges::max(last, {}, &Turn::film).film;
  }
  return {};
}

/// Temperatures and correction as one array of entries of like weight.
class Unknowns {
public:
  explicit Unknowns(int points) : kelvin_(30.0 * std::sqrt(points)) {}

  std::vector<double> packed(const FilmHeat& heat) const {
    std::vector<double> all;
    all.reserve(heat.temperatures.size() + 3 * heat.flow.wedge.size());
    for (const double T : heat.temperatures) all.push_back(T / kelvin_);
    for (const double theta : heat.flow.thinning) all.push_back(theta);
    for (const double W : heat.flow.wedge) all.push_back(W / wedge);
    for (const double r : heat.flow.density) all.push_back(r / density);
    return all;
  }

  /// Part of a change, added.
  void add(const std::vector<double>& change, double part, FilmHeat& heat) const {
    const double* value = change.data();
    for (double& T : heat.temperatures) T = std::max(T + part * kelvin_ * *value++, coldest);
    for (double& theta : heat.flow.thinning) theta += std::clamp(part * *value++, -largest_change, largest_change);
    for (double& W : heat.flow.wedge) W += part * wedge * *value++;
    for (double& r : heat.flow.density) r += part * density * *value++;
  }

private:
  static constexpr double wedge = 0.1, density = 0.03;  // that weigh as much as theta = 1
  double kelvin_;
};

double relative_change(double before, double after) {
  return before == after ? 0.0 : std::abs(after - before) / std::abs(after);
}

/// Of the mean temperatures where the contact is loaded, root mean square: at the exit a node may go on changing
/// between wet and dry. Common to all processes.
double temperature_change(const ContactFilm& film, const std::vector<double>& before,
                          const std::vector<double>& after) {
  if (before.empty()) return HUGE_VAL;
  double sums[] = {0.0, 0.0};
  const std::size_t rows = film.grid().y_count();
  for (std::size_t n = 0; n < before.size(); ++n) {
    if (film.pressure().row(static_cast<int>(n / rows))[n % rows] < loaded) continue;
    sums[0] += (after[n] - before[n]) * (after[n] - before[n]);
    sums[1] += 1.0;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, film.grid().comm());
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

FilmHeat cold_film(const ContactFilm& film, const HeatOptions& options) {
  const std::size_t nodes = film.grid().local_size();
  FilmHeat heat;
  heat.temperatures.assign(nodes * options.points, options.oil.temperature);
  heat.flow = {std::vector<double>(nodes, 0.0), std::vector<double>(nodes, 0.0), std::vector<double>(nodes, 1.0)};
  return heat;
}

}  // namespace

ThermalFilm solve_thermal(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                          const TractionModel& model, const SurfaceVelocities& velocities,
                          const StationaryResult& isothermal) {
  SolverOptions careful = options;
  careful.newton.max_iterations = std::min(options.newton.max_iterations, most_newton);
  careful.newton.krylov_tolerance = krylov_tolerance;
  const Unknowns unknowns(model.heat->points);
  AndersonMixing mixing(film.grid().comm(), memory, relaxation);
  FilmHeat present = cold_film(film, *model.heat);
  ThermalFilm found;
  found.film = isothermal;
  found.change = HUGE_VAL;
  double way = 1.0;
  std::vector<Turn> turns;
  while (found.turns < most_turns) {
    FilmHeat swept = present;
    Traction traction = heated_traction(model, film, velocities, swept);
    ++found.turns;
    const double warmed =
        temperature_change(film, found.traction.fields.temperature_mean, traction.fields.temperature_mean);
    const double friction = relative_change(found.traction.figures.coefficient, traction.figures.coefficient);
    found.traction = std::move(traction);
    turns.push_back({found.change, std::max({found.change / settled_film, friction / settled_friction,
                                             warmed / settled_temperature})});
    if (const auto change = settled(turns)) {
      found.change = *change;
      found.heat = std::move(present);
      return found;
    }

    const std::vector<double> before = unknowns.packed(present);
    std::vector<double> change = unknowns.packed(swept);
    for (std::size_t n = 0; n < change.size(); ++n) change[n] -= before[n];
    if (found.change > near || way < 1.0 || found.turns > patience) mixing.restart();
    if (found.turns > patience) way = std::min(way, careful_way);
    change = mixing.change(before, change);
    present.passing = std::move(swept.passing);
    std::optional<StationaryResult> next;
    FilmHeat moved;
    while (!next && way > shortest_way) {
      moved = present;
      unknowns.add(change, way, moved);
      film.set_correction(moved.flow);
      next = improve_stationary(film, load, careful, found.film.solution);
      if (!next) way *= 0.25;
    }
    if (!next) break;
    way = std::min(1.0, 2.0 * way);
    present = std::move(moved);
    const FilmFigures &last = found.film.figures, &now = next->figures;
    found.change = std::max(relative_change(last.central_film, now.central_film),
                            relative_change(last.smallest_film, now.smallest_film));
    found.newton += next->counts.newton;
    found.film = std::move(*next);
  }
  std::ostringstream message;
  message << "the film with its heat did not settle: after " << found.turns << " turns it changes by " << found.change
          << " in one; try a finer grid (grid_nx, grid_ny) or more points across the film (thermal_points), or "
             "thermal_model friction, which leaves the film cold";
  throw SolveError(message.str());
}

}  // namespace gearfilm

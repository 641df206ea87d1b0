#include "traction/coupled_film.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

#include "gearfilm/error.hpp"
#include "numerics/anderson_mixing.hpp"
#include "numerics/tuned.hpp"
#include "traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

const Tuned<int> most_turns("coupled_most_turns", 100, "turns of film and heat at most");
const Tuned<int> most_newton("coupled_most_newton", 15,
                             "iterations of a film in a turn; one that needs more has been moved too far");
// A new F moves the rows of the inlet by more than all others together: a rough linear solution would not see these.
const Tuned<double> krylov_tolerance("coupled_krylov_tolerance", 1e-5, "relative tolerance of linear solves in a turn");
const Tuned<double> relaxation("coupled_relaxation", 0.8, "part of the way to the new correction");
const Tuned<int> memory("coupled_memory", 6, "turns that are mixed");
const Tuned<double> near("coupled_near", 0.1, "relative change of the film from which on turns are mixed");
const Tuned<double> largest_change("coupled_largest_change", 1.0, "largest change of theta in a turn");
const Tuned<double> largest_shear("coupled_largest_shear", 4.0, "largest change of kappa in a turn");
constexpr double least_sheared = 36.0;  // that kappa begins below what a Newtonian film makes it
constexpr double least_across = 1e-3;   // of A, likewise
constexpr double coldest = 150.0;       // that mixing may make a temperature [K]
const Tuned<double> shortest_way("coupled_shortest_way", 1e-3, "shortest part of the way to a correction");
// Turns after which a film that has not settled goes on without mixing, part of the way.
const Tuned<int> patient_turns("coupled_patient_turns", 30,
                               "turns after which a film that has not settled goes on without mixing");
const Tuned<double> careful_way("coupled_careful_way", 0.25, "part of the way to a correction without mixing");

// Changes in a turn at which a film counts as settled.
const Tuned<double> settled_film("coupled_settled_film", 2e-4,
                                 "change of the film in a turn at which it counts as settled, relative");
const Tuned<double> settled_friction("coupled_settled_friction", 1e-3,
                                     "change of the friction force in a turn at which it counts as settled, relative");
const Tuned<double> settled_temperature("coupled_settled_temperature", 0.5,
                                        "change of temperatures in a turn at which they count as settled [K]");
const Tuned<double> settled_shear("coupled_settled_shear", 0.05,
                                  "change of kappa in a turn at which it counts as settled");
constexpr double loaded = 5e-3;  // of the pressure scale

/// What a turn changed, over what it may.
struct Turn {
  double film = HUGE_VAL;
  double unrest = HUGE_VAL;
};

/// So many turns in a row that change no more than so many times that: on a coarse grid a film may go on moving a
/// little, where a node at its exit changes between full and dry.
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
    all.reserve(heat.temperatures.size() + 5 * heat.flow.entrainment_excess.size());
    for (const double T : heat.temperatures) all.push_back(T / kelvin_);
    for (const double theta : heat.flow.log_poiseuille) all.push_back(theta);
    for (const double W : heat.flow.entrainment_excess) all.push_back(W / wedge);
    for (const double r : heat.flow.density_ratio) all.push_back(r / density);
    for (const double kappa : heat.flow.shear_index) all.push_back(kappa);
    for (const double A : heat.flow.cross_flow) all.push_back(A / across);
    return all;
  }

  /// Part of a change, added.
  void add(const std::vector<double>& change, double part, FilmHeat& heat) const {
    const double* value = change.data();
    for (double& T : heat.temperatures) T = std::max(T + part * kelvin_ * *value++, coldest);
    for (double& theta : heat.flow.log_poiseuille)
      theta += std::clamp<double>(part * *value++, -largest_change, largest_change);
    for (double& W : heat.flow.entrainment_excess) W += part * wedge * *value++;
    for (double& r : heat.flow.density_ratio) r += part * density * *value++;
    for (double& kappa : heat.flow.shear_index)
      kappa += std::clamp<double>(part * *value++, -largest_shear, largest_shear);
    for (double& A : heat.flow.cross_flow) A = std::max(A + part * across * *value++, least_across);
  }

private:
  static constexpr double wedge = 0.1, density = 0.03, across = 0.3;  // that weigh as much as theta = 1
  double kelvin_;
};

double relative_change(double before, double after) {
  return before == after ? 0.0 : std::abs(after - before) / std::abs(after);
}

/// Root mean square of the changes of a field where the contact is loaded: at the exit a node may go on changing
/// between full and dry. Common to all processes; infinite where nothing is known of before.
double loaded_change(const ContactFilm& film, const std::vector<double>& before, const std::vector<double>& after) {
  if (after.empty()) return 0.0;
  if (before.empty()) return HUGE_VAL;
  double sums[] = {0.0, 0.0};
  const std::size_t rows = film.grid().y_count();
  for (std::size_t n = 0; n < before.size(); ++n) {
    if (film.film_pressure().row(static_cast<int>(n / rows))[n % rows] < loaded) continue;
    sums[0] += (after[n] - before[n]) * (after[n] - before[n]);
    sums[1] += 1.0;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, film.grid().comm());
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

/// As warm everywhere as the oil that enters, and less sheared than the film without correction.
FilmHeat cold_film(const ContactFilm& film, const TractionModel& model) {
  FilmHeat cold;
  if (model.heats_film()) {
    cold.temperatures.assign(film.grid().local_size() * model.heat->points, model.heat->oil.temperature);
  }
  cold.flow = FlowFactors::none(film.grid().local_size());
  if (!model.shear_couples_film) return cold;
  FlowFactors sheared = sheared_flow(model, film);
  cold.flow.shear_index = std::move(sheared.shear_index);
  cold.flow.shear_power = sheared.shear_power;
  cold.flow.sheared = true;
  for (double& kappa : cold.flow.shear_index) kappa -= least_sheared;
  return cold;
}

}  // namespace

CoupledFilm solve_coupled(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                          const TractionModel& model, const StationaryResult& isothermal) {
  SolverOptions careful = options;
  careful.newton.max_iterations = std::min<int>(options.newton.max_iterations, most_newton);
  careful.newton.krylov_tolerance = krylov_tolerance;
  const Unknowns unknowns(model.heats_film() ? model.heat->points : 1);
  AndersonMixing mixing(film.grid().comm(), memory, relaxation);
  FilmHeat present = cold_film(film, model);
  CoupledFilm found;
  found.film = isothermal;
  found.change = HUGE_VAL;
  double way = 1.0;
  std::vector<Turn> turns;
  while (found.turns < most_turns) {
    FilmHeat swept = present;
    Traction traction = coupled_traction(model, film, swept);
    ++found.turns;
    const double warmed = loaded_change(film, found.traction.fields.temperature_mean, traction.fields.temperature_mean);
    const double sheared = loaded_change(film, present.flow.shear_index, swept.flow.shear_index);
    const double friction = relative_change(found.traction.quantities.coefficient, traction.quantities.coefficient);
    found.traction = std::move(traction);
    turns.push_back({found.change, std::max({found.change / settled_film, friction / settled_friction,
                                             warmed / settled_temperature, sheared / settled_shear})});
    if (const auto change = settled(turns)) {
      found.change = *change;
      found.heat = std::move(present);
      return found;
    }

    const std::vector<double> before = unknowns.packed(present);
    std::vector<double> change = unknowns.packed(swept);
    for (std::size_t n = 0; n < change.size(); ++n) change[n] -= before[n];
    if (found.change > near || way < 1.0 || found.turns > patient_turns || sheared > largest_shear / 4.0)
      mixing.restart();
    if (found.turns > patient_turns) way = std::min<double>(way, careful_way);
    change = mixing.change(before, change);
    present.passing = std::move(swept.passing);
    std::optional<StationaryResult> next;
    FilmHeat moved;
    while (!next && way > shortest_way) {
      moved = present;
      unknowns.add(change, way, moved);
      film.set_flow_factors(moved.flow);
      next = improve_stationary(film, load, careful, found.film.solution);
      if (!next) way *= 0.25;
    }
    if (!next) break;
    way = std::min(1.0, 2.0 * way);
    present = std::move(moved);
    const FilmQuantities &last = found.film.quantities, &now = next->quantities;
    // Between rough surfaces the mean gap, which is positive.
    found.change = std::max(relative_change(last.central_mean_gap, now.central_mean_gap),
                            relative_change(last.smallest_mean_gap, now.smallest_mean_gap));
    found.newton += next->counts.newton;
    found.film = std::move(*next);
  }
  std::ostringstream message;
  message << "the film with its " << (model.heats_film() ? "heat" : "shear") << " did not settle: after " << found.turns
          << " turns it changes by " << found.change << " in one; try a finer grid (grid_nx, grid_ny)";
  if (model.heats_film()) {
    message
        << " or more points across the film (thermal_points), or thermal_model friction, which leaves the film cold";
  } else {
    message << ", or friction_in_film no, which leaves the film Newtonian";
  }
  throw SolveError(message.str());
}

}  // namespace gearfilm

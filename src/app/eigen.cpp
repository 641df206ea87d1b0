// `gearfilm eigen`: natural frequencies of the dry pair, of the pair on its films, and multipliers of the orbit.
#include <algorithm>
#include <iomanip>

#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "orbits/described_dry_orbit.hpp"
#include "orbits/film_modes.hpp"
#include "orbits/floquet.hpp"
#include "orbits/train_on_films.hpp"
#include "output/progress.hpp"
#include "output/resumable_run.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "results/eigen_summary.hpp"
#include "results/friction_summary.hpp"
#include "results/orbit_summary.hpp"
#include "results/train_summary.hpp"

namespace gearfilm {
namespace {

/// Multipliers of the dry pair's periodic motion.
Summary dry_orbit_multipliers(const CaseInput& problem) {
  const OrbitProblem search = orbit_problem(problem);
  Summary summary;
  add_multipliers(search.mesh, multipliers(find_described_dry_orbit(search, unseen).orbit.monodromy), summary);
  return summary;
}

/// Those nearest zero [1/s]; null, and a warning, where they are not found: the pair's mode does not depend on them.
Summary film_eigenvalues(const CaseInput& problem, LubricatedPair& pair, Vec state, const Watcher& watcher) {
  Summary found = Summary::array();
  try {
    for (const FilmMode& mode : film_modes(pair, state, {.count = problem.modes.count, .watcher = watcher})) {
      found.push_back(mode.eigenvalue / problem.scales.time);
    }
  } catch (const SolveError& error) {
    warn(pair.system().comm(), "film_eigenvalues are null: ", error.what());
    return nullptr;
  }
  return found;
}

using Remarks = std::vector<std::string>;

/// The modes of the drive train, of the dry pair or on films; what is to be said of them goes to `remarks`.
void add_modes_of_train(const CaseInput& problem, const DampedTrain& train, const std::vector<ModeOnFilms>& on_films,
                        Summary& summary, Remarks& remarks) {
  add_train(problem, train, on_films, summary);
  for (const auto& more : {mode_lines(summary), damping_lines(summary)}) {
    remarks.insert(remarks.end(), more.begin(), more.end());
  }
}

/// The pair at rest on its films at the chosen position, linearised, with its drive train if there is one. What is to
/// be said of it goes to `remarks`.
Summary film_summary(const CaseInput& problem, const SharedDiscretisation& discretisation,
                     const std::optional<DampedTrain>& train, Summary summary, Remarks& remarks) {
  const Watcher& watcher = problem.numerics.solver.newton.watcher;
  MeshModel mesh = mesh_model(problem, problem.steady.position, MeshGeometry::held);
  mesh.train.reset();  // modes of a train follow from the stiffness of the films beneath the pair alone
  RestingPair rest(mesh, problem.numerics, discretisation);
  RatesOnGrids rates;
  const auto rates_of = [&](RestingPair& at_rest, const auto& lost) {
    return train_on_films(*train, at_rest.pair(), at_rest.state(), {.watcher = watcher}, lost);
  };
  SwingWatch watch{.watcher = watcher};
  if (train) watch.on_coarser = [&](RestingPair& coarser) { rates.coarser = rates_of(coarser, [](const auto&) {}); };
  const FilmSwing swing = film_swing(mesh, problem.numerics, rest, watch);
  const SwingQuantities quantities = quantities_of(swing, problem.scales);
  summary["position"] = problem.steady.position;
  summary["contacts"] = rest.contacts();
  summary["H0"] = rest.displacement();
  add_swing(swing, quantities, summary);
  const std::string remark = swing_remark(swing, quantities, summary["f_n"].get<double>());
  if (!remark.empty()) remarks.push_back(remark);
  if (train) {
    rates.fine = rates_of(rest, [&](const auto& what) { remarks.push_back("a mode on films is null: " + what); });
    add_modes_of_train(problem, *train, quantities_of(*train, rates, swing, problem.scales), summary, remarks);
  }
  if (!swing.on_stiff_films()) {
    summary["film_eigenvalues"] = film_eigenvalues(problem, rest.pair(), rest.state(), watcher);
    return summary;
  }
  summary["film_eigenvalues"] = nullptr;
  remarks.emplace_back(
      "film_eigenvalues are null: those nearest zero are films by themselves, far slower than the swing");
  return summary;
}

/// Multipliers of the periodic state by more periods than `gearfilm periodic` spends on them, which bounds those of the
/// films by themselves.
Summary orbit_multipliers(const CaseInput& problem, const SharedDiscretisation& films, ResumableRun& run) {
  const OrbitProblem search = orbit_problem(problem);
  const MeshModel& mesh = search.mesh;
  LongWork work(films->grid().comm());
  const auto on_step = [&](const StepRecord& record, const std::vector<ActiveContact>&) {
    work.report(worded("periodic state and its multipliers: mesh period ", std::fixed, std::setprecision(2),
                       record.T / mesh.path.mesh_period()));
  };
  const SearchWatch watch{.check_stop = run.stop().check_in(films->grid().comm()), .store = &run.checkpoint()};
  MeshMarch march = watched_march(search, films, watch, on_step);
  const PeriodicOrbit orbit = find_periodic_orbit(march, first_guess(search, films, dry_start(mesh)),
                                                  problem.search.options, [](const SearchPeriod&) {});
  const int needed = static_cast<int>(2 * mesh.freedoms());
  const FloquetMultipliers found =
      floquet_multipliers(march, orbit, {.periods = std::max(problem.modes.orbit_periods, needed)});
  Summary summary = {{"periods_used", orbit.periods_used}};
  add_multipliers(mesh, found.gear_pair, summary);
  if (found.film_bound) summary["film_multiplier_bound"] = *found.film_bound;
  return summary;
}

void print_result(MPI_Comm comm, const std::filesystem::path& folder, const Summary& summary) {
  ScreenTable table(summary);
  table.add("stiffness of the dry pair", "k_el", 1e-6, "N/um")
      .add("equivalent mass", "m_ge", 1.0, "kg")
      .add("natural frequency, dry", "f_n", 1.0, "Hz")
      .add("with its damper", "damped_frequency", 1.0, "Hz")
      .add("damping ratio", "damping_ratio")
      .add("position on the line of action", "position", 1e3, "mm")
      .add("contacts there", "contacts")
      .add("natural frequency on its films", "film_frequency", 1.0, "Hz")
      .add("damping ratio on its films", "film_damping_ratio");
  if (summary.contains("orbit")) {
    const Summary &orbit = summary["orbit"], &first = orbit["floquet"][0];
    std::string text = worded(std::setprecision(5), first[0].get<double>(), " ", std::showpos, first[1].get<double>(),
                              "i", std::noshowpos, " of modulus ", orbit["floquet_modulus"].get<double>());
    if (orbit.contains("film_multiplier_bound")) {
      text += worded(", those of the films below ", std::setprecision(2), orbit["film_multiplier_bound"].get<double>());
    }
    table.text("multipliers of the periodic state", text);
  }
  table.print(comm, folder);
}

}  // namespace

void run_eigen(MPI_Comm comm, const CaseInput& given) {
  if (given.traction && given.traction->heats_film()) {
    given.parameters.refuse("thermal.model",
                            "is film, but natural modes are those of isothermal films; use thermal.model none");
  }
  if (given.traction && given.traction->shear_couples_film) {
    given.parameters.refuse("friction.in_film",
                            "is yes, but natural modes are those of Newtonian films; use friction.in_film no");
  }
  require_inertia(given);
  require_moving_contacts(given, "eigen", true);
  require_standing_heights(given, "eigen");
  if (given.modes.of_orbit) {
    require_one_pattern(given, "eigen");
    require_moving_train(given, "eigen.orbit");
  }
  CaseInput problem = given;
  problem.numerics.solver.multigrid.precision =
      Precision::double_precision;  // eigenvalues have the digits of the products
  const SharedDiscretisation films = discretise(comm, problem);
  ResumableRun run(problem, films->grid(), "eigen");
  Summary summary = {{"case", problem.name}, {"nx", problem.numerics.nx}, {"ny", problem.numerics.ny}};
  summary.update(dry_pair_summary(problem));
  Remarks remarks;
  std::optional<DampedTrain> train;
  if (problem.pair.train) train = damped_train_of(problem);
  if (problem.dry()) {
    summary.update(damper_summary(problem, summary["f_n"].get<double>()));
    if (train) add_modes_of_train(problem, *train, {}, summary, remarks);
  } else {
    LongWork work(comm);
    const Watcher watcher = [&](const std::string& text) { work.report(text); };
    CaseInput watched = problem;
    watched.numerics.solver.newton.watcher = watcher;
    summary = film_summary(watched, films, train, std::move(summary), remarks);
  }
  if (problem.modes.of_orbit) {
    summary["orbit"] = problem.dry() ? dry_orbit_multipliers(problem) : orbit_multipliers(problem, films, run);
  }
  write_summary(comm, run.directory().path(), summary);
  run.complete();
  print_result(comm, run.directory().path(), summary);
  if (!problem.dry()) warn_of_heating(comm, problem, heating_at_pitch(problem));
  for (const std::string& remark : remarks) say(comm, remark);
  if (!train) return;
  for (const std::string& warning : train_warnings(problem, *train)) warn(comm, warning);
}

}  // namespace gearfilm

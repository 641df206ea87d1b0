// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include <iomanip>

#include "app/commands.hpp"
#include "app/error_bar.hpp"
#include "app/friction_summary.hpp"
#include "app/hard_entry.hpp"
#include "app/march_output.hpp"
#include "app/orbit_summary.hpp"
#include "app/result_warnings.hpp"
#include "app/screen_table.hpp"
#include "app/warning.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "input/case_numerics.hpp"
#include "orbits/described_dry_orbit.hpp"

namespace gearfilm {
namespace {

constexpr double typical_periods = 4.0;  // of the motion, for the time left
constexpr double many_swings = 40.0;     // of the pair in a mesh period

/// A pair that swings very often in a mesh period is taken to be in balance at every moment, where the case does not
/// say how it moves nor ask for what has inertia alone.
Case without_many_swings(MPI_Comm comm, const Case& given) {
  ParameterValues values = given.parameters;
  const bool multipliers_asked = values.given("periodic.multipliers") && values.yes("periodic.multipliers");
  const bool choosable = !values.given("motion") && !multipliers_asked && !values.given("periodic.order") &&
                         !values.yes("friction.in_motion") && given.march.model == MarchModel::dynamic &&
                         given.march.geometry == MeshGeometry::moving && !given.march.start_motion && swings(given);
  const double in_mesh_period = choosable ? mesh_period(given) / natural_period(given) : 0.0;
  if (in_mesh_period < many_swings) return given;
  say(comm, std::setprecision(3), "the pair would swing ", in_mesh_period,
      " times in a mesh period: bodies are taken to be in balance at every moment (motion: quasi_static); -motion "
      "dynamic follows their swings");
  values.set("motion", "quasi_static", "the choice of motion by the program");
  return make_case(values);
}

/// How far the total force is from the static one at most [static forces]: without inertia, about the size of the
/// swings that are left out.
double swing_left_out(const Summary& summary) {
  return std::max(summary["total_force_ratio_max"].get<double>() - 1.0,
                  1.0 - summary["total_force_ratio_min"].get<double>());
}

/// The undamped dry pair's orbit, for comparison; null where none is found without long marches, or where the pair
/// swings so often in a mesh period that an orbit without damping says nothing.
Summary dry_summary(const Case& problem, const MeshModel& mesh) {
  constexpr double most_oscillations = 10.0;
  if (mesh.inertia == 0.0 || mesh.periods() > 1 || mesh.frequency() * mesh.path.mesh_period() > most_oscillations)
    return nullptr;
  const std::optional<DryOrbit> dry = find_dry_orbit_soon(mesh, 0.0);
  if (!dry) return nullptr;
  Summary summary = {{"H0_after_leaving", dry->start.H0()},
                     {"V0_after_leaving", dry->start.V0()},
                     {"force_ratio_max", dry->largest_integral / problem.scales.static_force}};
  add_multipliers(mesh, multipliers(dry->monodromy), summary);
  for (const char* noise : {"stable", "damping_ratio"}) summary.erase(noise);  // without damping
  return summary;
}

/// The fewest mesh periods after which the states repeat; as many as there are states where none does before.
std::size_t true_order(const std::vector<Motion>& states, double tolerance) {
  for (std::size_t order = 1; order < states.size(); ++order) {
    if (states.size() % order != 0) continue;
    bool same = true;
    for (std::size_t n = order; n < states.size(); ++n) {
      same = same && length(difference(states[n], states[n - order])) < tolerance;
    }
    if (same) return order;
  }
  return states.size();
}

/// What multipliers and states say about orbits of other orders.
std::string advice(const Case& problem, const DescribedOrbit& found) {
  constexpr double noise = 20.0;  // of the search's tolerance
  const std::size_t order = true_order(found.states_after_leaving, noise * problem.search.options.tolerance);
  const long pattern = problem.pair.teeth.pattern();
  const auto asked = static_cast<std::size_t>(problem.search.order);
  if (pattern == 1 && order < asked) {
    return " this state repeats after " + std::to_string(order) + " mesh period(s) already: it is of order " +
           std::to_string(order) + ", not " + std::to_string(asked);
  }
  if (!found.decay) return "";
  const auto& mu = found.decay->multipliers;
  const double lowest = std::min(mu[0].real(), mu[1].real());
  if (mu[0].imag() != 0.0 || lowest > -1.0) return "";
  return " a multiplier has passed -1: the motion doubles its period; try -periodic_order " + std::to_string(2 * asked);
}

std::string stability(const Summary& summary) {
  if (!summary.contains("stable")) return "not asked for (periodic.multipliers no)";
  return worded(summary["stable"].get<bool>() ? "stable" : "unstable", ", a disturbance is multiplied by ",
                std::setprecision(4), summary["floquet_modulus"].get<double>(), " +- ", std::setprecision(1),
                summary["floquet_modulus_error"].get<double>(), " in a period");
}

void print_result(MPI_Comm comm, const std::filesystem::path& folder, const Case& problem, const Summary& summary,
                  const std::optional<LargestError>& error, const std::string& advice) {
  const bool in_balance = problem.march.motion == PairMotion::quasi_static;
  ScreenTable(summary)
      .text("periodic state", in_balance ? "of bodies in balance at every moment" : stability(summary))
      .add("largest force on one contact", "force_ratio_max", 1.0, "static forces")
      .add("total force, largest", "total_force_ratio_max", 1.0, "static forces")
      .add("total force, smallest", "total_force_ratio_min", 1.0, "static forces")
      .add("largest pressure", "p_max", 1e-9, "GPa")
      .add("  of the outlet's spike", "p_spike_max", 1e-9, "GPa")
      .add("smallest film", "h_min", 1e6, "um")
      .add("central film at the pitch point", "pitch_h_central", 1e6, "um")
      .add("transmission error, peak to peak", "transmission_error_peak_to_peak", 1e6, "um")
      .add("free oscillation", "free_frequency", 1.0, "Hz")
      .add("its damping ratio", "damping_ratio")
      .add("mean friction coefficient", "mean_friction_coefficient")
      .add("efficiency of the mesh", "efficiency")
      .print(comm, folder);
  if (in_balance) {
    say(comm, std::setprecision(2), "left out: swings of the total force by up to ", swing_left_out(summary),
        " static forces or a little more either way, and of the pressures and films under it, after contacts come and "
        "go");
  }
  note_spike(comm, summary);
  if (!advice.empty()) say(comm, advice.substr(1));
  if (problem.dry() || (error && error->relative <= tolerable_error(problem))) return;
  warn(comm,
       error ? error->text() + ", the largest of all (each figure's _error is in summary.json)"
             : "the errors of the figures are not known, since no coarser grid has this state",
       "; lower grid.accuracy, or raise grid.nx and grid.ny and lower time.dt");
}

void find_and_write(MPI_Comm comm, const Case& problem) {
  require_moving_contacts(problem, "periodic", true);
  require_one_pattern(problem, "periodic");
  const SharedDiscretisation films = discretise(comm, problem);
  const Grid& grid = films->grid();
  ResumableRun run(problem, grid, "periodic");
  const OrbitProblem search = orbit_problem(problem);
  const MeshModel& mesh = search.mesh;
  if (!mesh.teeth.rigid()) warn_of_hard_entry(comm, mesh);
  MarchOutput output(run, problem, grid, mesh, MarchPurpose::search,
                     (problem.dry() ? 1.0 : typical_periods) * mesh.periods());
  const SearchWatch watch = {
      .on_step = [&](const StepRecord& record,
                     const std::vector<LiveContact>& contacts) { output.step(record, contacts); },
      .on_period = [&](const SearchPeriod& period) { output.end_search_period(period); },
      .on_coarse_period = [&](const SearchPeriod& period) { output.note("coarser grid: " + text_of(period)); },
      .on_trouble = [&](const std::string& trouble) { output.note(trouble + "; the search goes on without"); },
      .check_stop = run.stop().check_in(comm),
      .keeper = &run.checkpoint()};
  FoundOrbit found;
  try {
    if (problem.dry()) {
      found.own = find_described_dry_orbit(search, watch.on_step, run.stop().count_in(comm));
    } else {
      found = find_orbit(search, films, dry_start(mesh), watch);
      find_coarse_orbit(search, watch, comm, found);
    }
  } catch (const Unfinished&) {
    Summary summary = march_summary(problem, mesh, output.statistics());
    summary["completed"] = false;
    output.finish();
    write_summary(comm, run.directory().path(), summary);  // what was marched until then
    throw;
  }
  const double begin = found.own.orbit.begin, end = begin + mesh.period();
  output.file().attribute("/history", "periodic_from", begin);
  output.file().attribute("/history", "periodic_to", end);
  Summary summary = {{"case", problem.name},
                     {"nx", problem.numerics.nx},
                     {"ny", problem.numerics.ny},
                     {"dT", problem.numerics.steps.dT}};
  summary["motion"] = problem.parameters.text("motion");
  summary["order"] = problem.search.order;
  summary["static_force"] = problem.scales.operation.load;
  summary["mesh_period"] = problem.scales.time * mesh.path.mesh_period();
  summary.update(orbit_summary(mesh, found.own));
  const std::vector<OrbitError> errors = errors_of(found);
  add_errors(errors, mesh.scales, summary);
  add_efficiency(mesh, summary);
  summary["spectrum_peaks"] = output.write_spectrum(begin, end, SpectralWindow::none);
  summary["dry"] = dry_summary(problem, mesh);
  summary["completed"] = true;
  output.finish();
  write_summary(comm, run.directory().path(), summary);
  run.complete();
  print_result(comm, run.directory().path(), problem, summary, largest_of(errors, mesh.scales),
               advice(problem, found.own));
  if (!problem.dry()) warn_of_heating(comm, problem, heating_at_pitch(problem));
  warn_of_validity(comm, summary);
}

}  // namespace

void run_periodic(MPI_Comm comm, const Case& problem) {
  require_inertia(problem);
  find_and_write(comm, without_many_swings(comm, problem));
}

}  // namespace gearfilm

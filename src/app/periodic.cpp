// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include <algorithm>
#include <array>
#include <iomanip>

#include "app/commands.hpp"
#include "app/corner_contact.hpp"
#include "app/march_output.hpp"
#include "app/result_warnings.hpp"
#include "film/domain_margins.hpp"
#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "orbits/settled_march.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "results/flank_result.hpp"
#include "results/friction_summary.hpp"
#include "results/march_summary.hpp"
#include "results/orbit_summary.hpp"

namespace gearfilm {
namespace {

constexpr double typical_periods = 4.0;  // of the motion, for the time left

/// How far the total force is from the static one at most [static forces]: without inertia, about the size of the
/// swings that are left out.
double swing_left_out(const Summary& summary) {
  return std::max(summary["total_force_ratio_max"].get<double>() - 1.0,
                  1.0 - summary["total_force_ratio_min"].get<double>());
}

/// What multipliers and states say about orbits of other orders.
std::string advice(const CaseInput& problem, const DescribedOrbit& found) {
  constexpr double noise = 20.0;  // of the search's tolerance
  const std::size_t order = true_order(found.states_after_leaving, noise * problem.search.options.tolerance);
  const long pattern = whole_pattern(problem);
  const auto asked = static_cast<std::size_t>(problem.search.order);
  if (pattern == 1 && order < asked) {
    return " this state repeats after " + std::to_string(order) + " mesh period(s) already: it is of order " +
           std::to_string(order) + ", not " + std::to_string(asked);
  }
  if (!found.decay) return "";
  const bool doubles = std::ranges::any_of(found.decay->multipliers,
                                           [](const auto& mu) { return mu.imag() == 0.0 && mu.real() <= -1.0; });
  if (!doubles) return "";
  return " a multiplier has passed -1: the motion doubles its period; try -periodic_order " + std::to_string(2 * asked);
}

std::string stability(const Summary& summary) {
  if (!summary.contains("stable")) return "not asked for (periodic.multipliers no)";
  return worded(summary["stable"].get<bool>() ? "stable" : "unstable", ", a disturbance is multiplied by ",
                std::setprecision(4), summary["floquet_modulus"].get<double>(), " +- ", std::setprecision(1),
                summary["floquet_modulus_error"].get<double>(), " in a period");
}

void print_result(MPI_Comm comm, const std::filesystem::path& folder, const CaseInput& problem, const Summary& summary,
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
      .add("largest Dang Van stress, pinion", "dang_van_max_pinion", 1e-6, "MPa")
      .add("  in the wheel", "dang_van_max_wheel", 1e-6, "MPa")
      .add("  least safety, pinion", "safety_dang_van_pinion")
      .add("  in the wheel", "safety_dang_van_wheel")
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
       error ? error->text() + ", the largest apart from a spike's (each quantity's _error is in summary.json)"
             : "the errors of the quantities are not known, since no coarser grid has this state",
       "; lower grid.accuracy, or raise grid.nx and grid.ny and lower time.dt");
}

SearchWatch watch_of(MPI_Comm comm, ResumableRun& run, MarchOutput& output) {
  return {.on_step = [&](const StepRecord& record,
                         const std::vector<ActiveContact>& contacts) { output.step(record, contacts); },
          .on_period = [&](const SearchPeriod& period) { output.end_search_period(period); },
          .on_coarse_period = [&](const SearchPeriod& period) { output.note("coarser grid: " + text_of(period)); },
          .on_trouble = [&](const std::string& trouble) { output.note(trouble + "; the search goes on without"); },
          .check_stop = run.stop().check_in(comm),
          .store = &run.checkpoint()};
}

void write_state(const CaseInput& problem, const MeshModel& mesh, const FoundOrbit& found,
                 const std::optional<FlankResults>& flanks, ResumableRun& run, MarchOutput& output) {
  MPI_Comm comm = output.file().comm();
  const double begin = found.own.orbit.begin, end = begin + mesh.period();
  output.file().attribute("/history", "periodic_from", begin);
  output.file().attribute("/history", "periodic_to", end);
  const std::vector<OrbitError> errors = errors_of(found);
  Summary summary = periodic_summary(problem, mesh, found, errors);
  summary["spectrum_peaks"] = output.write_spectrum(begin, end, SpectralWindow::none);
  summary["dry"] = dry_summary(mesh);
  output.add_train_motion(begin, end, summary);
  if (mesh.rating && !problem.dry()) summary["safety"] = output.safeties(begin, end);
  if (mesh.fatigue) add_flanks(mesh, flanks, summary);
  output.write_flanks(flanks);
  summary["completed"] = true;
  output.finish();
  write_summary(comm, run.directory().path(), summary);
  run.complete();
  print_result(comm, run.directory().path(), problem, summary, largest_of(errors, mesh.scales),
               advice(problem, found.own));
  if (!problem.dry()) warn_of_heating(comm, problem, heating_at_pitch(problem));
  warn_of_validity(comm, problem, summary);
}

/// No state has been found from the dry pair's orbit, but one of the pair at another speed.
struct StateBeside {
  double speed_rpm = 0.0;
  Motion motion;  ///< where it begins, in the units of the case
  std::string why;
};

/// Beyond a speed at which two states meet and end, searches linger where they were. States at other speeds that
/// searches find lead past that.
std::optional<StateBeside> state_beside(MPI_Comm comm, const CaseInput& problem, const std::string& why,
                                        const StopCheck& check_stop) {
  constexpr std::array speeds = {1.02, 0.98};  // over that of the case
  const std::string speed = "pinion.speed_rpm";
  if (problem.dry() || problem.pair.train || problem.march.start_motion) return {};
  if (problem.march.motion == PairMotion::quasi_static) return {};
  for (const double ratio : speeds) {
    const double beside = ratio * problem.parameters.real(speed);
    try {
      OrbitProblem search = orbit_problem(case_with_parameter(problem, speed, beside));
      search.search.with_multipliers = false;
      const DescribedOrbit found =
          find_orbit(search, discretise(comm, search), dry_start(search.mesh), {.check_stop = check_stop}).own;
      const PairState start{found.orbit.start.motion, {}};
      return StateBeside{beside, rescaled(start, search.mesh.scales, problem.scales).motion, why};
    } catch (const SolveError&) {
      // The other speed may have one.
    } catch (const InputError&) {
      // That speed may not be given.
    }
  }
  return {};
}

void search(MPI_Comm comm, const CaseInput& given) {
  std::string remark;
  const CaseInput problem = periodic_case(given, remark);
  if (!remark.empty()) say(comm, remark);
  const SharedDiscretisation films = discretise(comm, problem);
  ResumableRun run(problem, films->grid(), "periodic");
  const OrbitProblem search = orbit_problem(problem);
  if (!search.mesh.teeth.rigid()) warn_of_corner_contact(comm, search.mesh);
  MarchOutput output(run, problem, films->grid(), search.mesh, MarchPurpose::search,
                     (problem.dry() ? 1.0 : typical_periods) * search.mesh.periods());
  FoundOrbit found;
  std::optional<FlankResults> flanks;
  try {
    found = find_orbit_with_errors(search, problem.dry() ? nullptr : films, watch_of(comm, run, output));
    if (search.mesh.fatigue) flanks = flank_results(search, films, found.own.orbit, run.stop().check_in(comm));
  } catch (const Unfinished& error) {
    if (dynamic_cast<const NoPeriodicState*>(&error) != nullptr) {
      const auto beside = state_beside(comm, problem, error.what(), run.stop().check_in(comm));
      if (beside) throw StateBeside(*beside);
    }
    Summary summary = march_summary(problem, search.mesh, output.statistics());
    summary["completed"] = false;
    output.finish();
    write_summary(comm, run.directory().path(), summary);  // what was marched until then
    throw;
  }
  write_state(problem, search.mesh, found, flanks, run, output);
}

/// From the dry pair's orbit; where none is found, from a state at another speed.
void search_anywhere(MPI_Comm comm, const CaseInput& given) {
  const std::array<std::string, 2> start = {"start.H0", "start.V0"};
  ParameterValues values = given.parameters;
  const auto begin_at = [&](const std::array<std::string, 2>& motion) {
    for (std::size_t k : {0, 1}) values.set(start[k], motion[k], "the start that the program chose");
    return make_case_like(given, values);
  };
  // A run that began again there goes on there.
  if (given.run.restart && !given.march.start_motion) {
    const auto H0 = parameter_of_kept_run(comm, given.run.directory, start[0]),
               V0 = parameter_of_kept_run(comm, given.run.directory, start[1]);
    if (H0 && V0) return search(comm, begin_at({*H0, *V0}));
  }
  try {
    search(comm, given);
  } catch (const StateBeside& found) {
    say(comm, found.why, ": the search begins again from the state at ", found.speed_rpm, " rpm");
    CaseInput again =
        begin_at({worded(std::setprecision(10), found.motion.H0()), worded(std::setprecision(10), found.motion.V0())});
    again.run.restart = false;
    search(comm, again);
  }
}

}  // namespace

// Forces of a pair in motion are known when they are computed.
void run_periodic(MPI_Comm comm, const CaseInput& given) {
  const std::string whole_face = "grid.whole_face";
  ParameterValues values = given.parameters;
  const bool asked_for = values.text(whole_face) == "yes";
  values.set(whole_face, "yes", "the choice of rows by the program");
  // A run that began again over the whole face goes on there.
  if (given.run.restart && !asked_for && parameter_of_kept_run(comm, given.run.directory, whole_face) == "yes") {
    search_anywhere(comm, make_case_like(given, values));
    return;
  }
  try {
    search_anywhere(comm, given);
  } catch (const EdgesReached& error) {
    if (asked_for) throw;
    say(comm, error.what(), ": the search begins again with films over the whole face (", whole_face, ": yes)");
    CaseInput over_the_face = make_case_like(given, values);
    over_the_face.run.restart = false;
    search_anywhere(comm, over_the_face);
  }
}

}  // namespace gearfilm

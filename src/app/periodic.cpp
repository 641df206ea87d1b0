// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>

#include "app/commands.hpp"
#include "app/corner_contact.hpp"
#include "app/march_output.hpp"
#include "app/over_the_face.hpp"
#include "app/result_warnings.hpp"
#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "orbits/orbit_starts.hpp"
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
  const double modulus = summary["floquet_modulus"].get<double>(),
               error = summary["floquet_modulus_error"].get<double>();
  const std::string word = summary["stable"].get<bool>() ? "stable" : "unstable";
  const bool known = std::abs(modulus - 1.0) > error;
  return worded(known ? word : word + " by less than the error", ", a disturbance is multiplied by ",
                std::setprecision(4), modulus, " +- ", std::setprecision(1), error, " in a period");
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

/// One search with its files.
class SearchRun {
public:
  SearchRun(MPI_Comm comm, CaseInput problem)
      : comm_(comm),
        problem_(std::move(problem)),
        films_(discretise(comm, problem_)),
        run_(problem_, films_->grid(), "periodic"),
        search_(orbit_problem(problem_)) {
    const MeshModel& mesh = search_.mesh;
    if (!mesh.teeth.rigid()) warn_of_corner_contact(comm, mesh);
    output_.emplace(run_, problem_, films_->grid(), mesh, MarchPurpose::search,
                    (problem_.dry() ? 1.0 : typical_periods) * mesh.periods());
  }

  StopCheck check_stop() const { return run_.stop().check_in(comm_); }

  FoundOrbit find() {
    try {
      FoundOrbit found =
          find_orbit_with_errors(search_, problem_.dry() ? nullptr : films_, watch_of(comm_, run_, *output_));
      if (search_.mesh.fatigue) flanks_ = flank_results(search_, films_, found.own.orbit, check_stop());
      return found;
    } catch (const Unfinished&) {
      Summary summary = march_summary(problem_, search_.mesh, output_->statistics());
      summary["completed"] = false;
      output_->finish();
      write_summary(comm_, run_.directory().path(), summary);  // what was marched until then
      throw;
    }
  }

  void write(const FoundOrbit& found) {
    const MeshModel& mesh = search_.mesh;
    const double begin = found.own.orbit.begin, end = begin + mesh.period();
    output_->file().attribute("/history", "periodic_from", begin);
    output_->file().attribute("/history", "periodic_to", end);
    const std::vector<OrbitError> errors = errors_of(found);
    Summary summary = periodic_summary(problem_, mesh, found, errors);
    summary["spectrum_peaks"] = output_->write_spectrum(begin, end, SpectralWindow::none);
    summary["dry"] = dry_summary(mesh);
    output_->add_train_motion(begin, end, summary);
    if (mesh.rating && !problem_.dry()) summary["safety"] = output_->safeties(begin, end);
    if (mesh.fatigue) add_flanks(mesh, flanks_, summary);
    output_->write_flanks(flanks_);
    summary["completed"] = true;
    output_->finish();
    write_summary(comm_, run_.directory().path(), summary);
    run_.complete();
    print_result(comm_, run_.directory().path(), problem_, summary, largest_of(errors, mesh.scales),
                 advice(problem_, found.own));
    if (!problem_.dry()) warn_of_heating(comm_, problem_, heating_at_pitch(problem_));
    warn_of_validity(comm_, problem_, summary);
  }

private:
  MPI_Comm comm_;
  CaseInput problem_;
  SharedDiscretisation films_;
  ResumableRun run_;
  OrbitProblem search_;
  std::optional<MarchOutput> output_;
  std::optional<FlankResults> flanks_;
};

/// From the dry pair's orbit, or another start that the program chooses; each begins the files again.
void search_anywhere(MPI_Comm comm, const CaseInput& given) {
  const std::array<std::string, 2> start = {"start.H0", "start.V0"};
  std::string remark;
  const CaseInput problem = periodic_case(given, remark);
  if (!remark.empty()) say(comm, remark);
  const auto begin_at = [&](const std::array<std::string, 2>& motion) {
    ParameterValues values = problem.parameters;
    for (std::size_t k : {0, 1}) values.set(start[k], motion[k], "the start that the program chose");
    return make_case_like(problem, values);
  };
  std::optional<SearchRun> run;
  // A run that began again from another start goes on there.
  if (problem.run.restart && !problem.march.start_motion) {
    const auto H0 = parameter_of_kept_run(comm, problem.run.directory, start[0]),
               V0 = parameter_of_kept_run(comm, problem.run.directory, start[1]);
    if (H0 && V0) {
      run.emplace(comm, begin_at({*H0, *V0}));
      return run->write(run->find());
    }
  }
  const auto search = [&](const std::optional<StateBeside>& from) {
    CaseInput here = problem;
    if (from) {
      say(comm, from->why, ": the search begins again from the state at ",
          from->speed_ratio * problem.parameters.real("pinion.speed_rpm"), " rpm");
      here = begin_at(
          {worded(std::setprecision(10), from->motion.H0()), worded(std::setprecision(10), from->motion.V0())});
      here.run.restart = false;
    }
    run.reset();
    run.emplace(comm, std::move(here));
    return run->find();
  };
  const auto beside = [&](const OrbitProblem& at_speed) {
    return find_orbit_beside(comm, at_speed, run->check_stop());
  };
  const FoundOrbit found =
      find_orbit_from_starts(orbit_problem(problem), problems_at_speeds(problem), {search, beside});
  run->write(found);
}

}  // namespace

void run_periodic(MPI_Comm comm, const CaseInput& given) {
  run_over_the_face_if_needed(comm, given, "the search",
                              [&](const CaseInput& problem) { search_anywhere(comm, problem); });
}

}  // namespace gearfilm

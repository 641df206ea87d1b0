// `gearfilm transient`: the gear pair marched in time through its mesh periods.
#include <sstream>

#include "app/commands.hpp"
#include "app/corner_contact.hpp"
#include "app/flank_march.hpp"
#include "app/march_output.hpp"
#include "app/over_the_face.hpp"
#include "app/result_warnings.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "results/friction_summary.hpp"
#include "results/march_summary.hpp"

namespace gearfilm {
namespace {

/// The end of the march: that of the line of action where one contact is followed along it.
double end_of(const CaseInput& problem, const MeshModel& mesh) {
  return mesh.load ? mesh.path.exit_time(0) : mesh.path.time_after(problem.march.mesh_periods);
}

/// A march that goes on cannot end before where it is.
void require_beyond(ResumableRun& run, const CaseInput& problem, const MeshModel& mesh) {
  const double kept = run.checkpoint().kept_until();
  if (kept <= end_of(problem, mesh) * (1.0 + 1e-9)) return;
  problem.parameters.refuse("mesh_periods", "is " + format_value(problem.march.mesh_periods) + ", but the march in '" +
                                                problem.run.directory.string() + "' has come to " +
                                                format_value(mesh.path.mesh_periods(kept)) + "; give at least as many");
}

std::string mesh_periods(int count) { return count == 1 ? "mesh period" : std::to_string(count) + " mesh periods"; }

/// Whether the march has come to repeat, and how it settles.
void print_recurrence(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("repeats_every")) return;
  std::ostringstream text;
  text.precision(3);
  const double defect = summary["repeats_within"].get<double>();
  if (summary["repeats_every"].is_null()) {
    text << "does not repeat yet";
    if (summary.contains("settles_on") && !summary["settles_on"].is_null()) {
      text << ", but settles on a motion that repeats every " << mesh_periods(summary["settles_on"].get<int>());
    }
    text << ": (H0, V0) changes by " << defect << " in a mesh period";
  } else {
    text << "repeats every " << mesh_periods(summary["repeats_every"].get<int>()) << " within " << defect
         << " in (H0, V0)";
  }
  if (summary.contains("settling")) {
    const Summary& settling = summary["settling"];
    const int periods = settling["mesh_periods"].get<int>();
    text << "; in " << (periods == 1 ? "one" : std::to_string(periods)) << " a disturbance is multiplied by "
         << settling["modulus"].get<double>() << " +- " << settling["modulus_error"].get<double>();
  }
  say(comm, text.str());
}

void print_extremes(MPI_Comm comm, const std::filesystem::path& folder, const Summary& summary) {
  ScreenTable(summary)
      .add("largest force on one contact", "force_ratio_max", 1.0, "static forces")
      .add("largest pressure", "p_max", 1e-9, "GPa")
      .add("smallest film", "h_min", 1e6, "um")
      .text("losses of contact", std::to_string(summary["contact_losses"].size()))
      .print(comm, folder);
}

std::optional<FlankResults> add_fatigue(const CaseInput& problem, const MeshModel& mesh, const Grid& grid,
                                        const FlankMarch& flanks, Summary& summary) {
  std::optional<FlankResults> results = flanks.results(grid, mesh_after_leaving(problem));
  add_flanks(mesh, results, summary);
  return results;
}

/// What is known so far, into the files; and its summary.
Summary write_march(const ResumableRun& run, const CaseInput& problem, const MeshModel& mesh,
                    const std::optional<GridShape>& grid, const FlankMarch& flanks, MarchOutput& output,
                    bool completed) {
  Summary summary = march_summary(problem, mesh, output.statistics());
  std::optional<FlankResults> fatigue;
  if (mesh.fatigue && grid) fatigue = add_fatigue(problem, mesh, Grid(output.file().comm(), *grid), flanks, summary);
  output.write_flanks(fatigue);
  if (grid) summary["final_grid"] = grid_summary(mesh.scales, *grid);
  if (mesh.rating && !problem.dry()) summary["safety"] = output.safeties(0.0, HUGE_VAL);
  summary["completed"] = completed;
  if (completed && problem.march.spectrum_periods) {
    const double end = end_of(problem, mesh);
    const double begin = mesh.path.time_after(mesh.path.mesh_periods(end) - *problem.march.spectrum_periods);
    summary["spectrum_peaks"] = output.write_spectrum(begin, end, SpectralWindow::hann);
  }
  output.describe_recurrence(summary);
  output.add_train_motion(0.0, output.last_time(), summary);
  output.finish();
  write_summary(output.file().comm(), run.directory().path(), summary);
  return summary;
}

void march_case(MPI_Comm comm, const CaseInput& given) {
  std::string remark;
  const CaseInput problem = transient_case(given, remark);
  if (!remark.empty()) say(comm, remark);
  const SharedDiscretisation films = discretise(comm, problem);
  // A march that failed may go on with other steps.
  ResumableRun run(problem, films->grid(), "transient", {"time", "solver"});
  MeshModel mesh = mesh_model(problem, problem.march.start_position, problem.march.geometry, problem.march.course);
  keep_sections(mesh);
  require_beyond(run, problem, mesh);
  if (!mesh.teeth.rigid() && !mesh.load) warn_of_corner_contact(comm, mesh);
  MarchOutput output(run, problem, films->grid(), mesh, MarchPurpose::march,
                     mesh.path.mesh_periods(end_of(problem, mesh)));
  FlankMarch flanks(comm, run.checkpoint(), mesh, end_of(problem, mesh));
  const auto observer = [&](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
    flanks.step(record, contacts);
    output.step(record, contacts);
    if (run.checkpoint().is_new(record)) run.stop().check(comm, mesh.path.mesh_periods(record.T));
  };
  PairMarch march = make_pair_march(problem, mesh, problem.dry() ? nullptr : films, observer, &run.checkpoint());
  try {
    march.start(problem.march.start_motion);
    march.run(end_of(problem, mesh));
  } catch (const Unfinished&) {
    write_march(run, problem, mesh, march.grid_shape(), flanks, output, false);  // what was computed until then
    throw;
  }
  const Summary summary = write_march(run, problem, mesh, march.grid_shape(), flanks, output, true);
  print_recurrence(comm, summary);
  print_extremes(comm, run.directory().path(), summary);
  warn_of_validity(comm, problem, summary);
  if (!problem.dry()) warn_of_heating(comm, problem, heating_at_pitch(problem));
  run.complete();
}

}  // namespace

void run_transient(MPI_Comm comm, const CaseInput& given) {
  run_over_the_face_if_needed(comm, given, "the march", [&](const CaseInput& problem) { march_case(comm, problem); });
}

}  // namespace gearfilm

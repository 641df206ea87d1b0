// `gearfilm transient`: the gear pair marched in time through its mesh periods.
#include "gearfilm/app/commands.hpp"
#include "gearfilm/app/friction_summary.hpp"
#include "gearfilm/app/hard_entry.hpp"
#include "gearfilm/app/march_output.hpp"
#include "gearfilm/dynamics/dry_pair.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"

namespace gearfilm {
namespace {

/// The end of the march: that of the line of action where one contact is followed along it.
double end_of(const Case& problem, const MeshModel& mesh) {
  return mesh.load ? mesh.path.exit_time(0) : problem.march.mesh_periods * mesh.path.mesh_period();
}

/// A march that goes on cannot end before where it is.
void require_beyond(ResumableRun& run, const Case& problem, const MeshModel& mesh) {
  const double kept = run.checkpoint().kept_until();
  if (kept <= end_of(problem, mesh) * (1.0 + 1e-9)) return;
  throw InputError(problem.parameters.origin("mesh_periods") + ": 'mesh_periods' is " +
                   format_value(problem.march.mesh_periods) + ", but the march in '" + problem.run.directory.string() +
                   "' has come to " + format_value(kept / mesh.path.mesh_period()) + "; give at least as many");
}

template <class March>
void drive(March&& march, const Case& problem) {
  march.start(problem.march.start_motion);
  march.run(end_of(problem, march.mesh()));
}

}  // namespace

void run_transient(MPI_Comm comm, const Case& problem) {
  require_inertia(problem);
  const SharedDiscretisation films = discretise(comm, problem);
  const Grid& grid = films->grid();
  // A march that failed may go on with other steps.
  ResumableRun run(problem, grid, "transient", {"time", "solver"});
  const MeshModel mesh = mesh_model(problem, problem.march.start_position, problem.march.geometry);
  require_beyond(run, problem, mesh);
  if (!mesh.teeth.rigid() && !mesh.load) warn_of_hard_entry(comm, mesh);
  const bool lubricated = problem.march.model != MarchModel::dry;
  MarchOutput output(run, problem, grid, mesh, MarchPurpose::march, end_of(problem, mesh) / mesh.path.mesh_period());
  const auto observer = [&](const StepRecord& record, const std::vector<LiveContact>& contacts) {
    output.step(record, contacts);
    if (run.checkpoint().is_new(record)) run.stop().check(comm, record.T / mesh.path.mesh_period());
  };
  std::optional<MeshMarch> march;
  const auto write = [&](bool completed) {
    Summary summary = march_summary(problem, mesh, output.statistics());
    if (march) summary["final_grid"] = grid_summary(mesh.scales, march->discretisation()->grid().shape());
    summary["completed"] = completed;
    if (completed && problem.march.spectrum_periods) {
      const double end = end_of(problem, mesh);
      const double begin = end - *problem.march.spectrum_periods * mesh.path.mesh_period();
      summary["spectrum_peaks"] = output.write_spectrum(begin, end, SpectralWindow::hann);
    }
    output.finish();
    write_summary(comm, run.directory().path(), summary);
    if (!completed) return;
    warn_of_roughness(comm, summary, "lambda_min");
    warn_of_missed_temperatures(comm, summary, "temperatures_missed_max");
  };
  try {
    if (lubricated) {
      march = make_march(problem, films, mesh, observer, &run.checkpoint());
      drive(*march, problem);
    } else {
      drive(DryMarch(mesh, problem.numerics.steps.dT, observer, 0.0, &run.checkpoint()), problem);
    }
  } catch (const Unfinished&) {
    write(false);  // what was computed until then
    throw;
  }
  write(true);
  if (lubricated) warn_of_heating(comm, problem, heating_at_pitch(problem));
  run.complete();
}

}  // namespace gearfilm

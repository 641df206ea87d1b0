// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include "gearfilm/app/commands.hpp"
#include "gearfilm/app/march_output.hpp"
#include "gearfilm/app/orbit_run.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"

namespace gearfilm {
namespace {

constexpr double typical_periods = 4.0;  // for the time left

/// The undamped dry pair's orbit, for comparison; null where there is none.
Summary dry_summary(const Case& problem, const MeshModel& mesh) {
  try {
    const DryOrbit dry = find_dry_orbit(mesh, 0.0);
    Summary summary = {{"H0_after_leaving", dry.start.H0},
                       {"V0_after_leaving", dry.start.V0},
                       {"force_ratio_max", dry.largest_integral / problem.scales.static_force}};
    add_multipliers(mesh, multipliers(dry.monodromy), summary);
    for (const char* noise : {"stable", "damping_ratio"}) summary.erase(noise);  // without damping
    return summary;
  } catch (const SolveError&) {
    return nullptr;
  }
}

}  // namespace

void run_periodic(MPI_Comm comm, const Case& problem) {
  require_inertia(problem);
  require_moving_films(problem, "periodic");
  const SharedDiscretisation films = discretise(comm, problem);
  const Grid& grid = films->grid();
  ResumableRun run(problem, grid, "periodic");
  const MeshModel mesh = mesh_after_leaving(problem);
  const OrbitGuess guess = dry_guess(problem, films, find_dry_orbit(mesh, typical_film_damping));
  MarchOutput output(run, problem, grid, mesh, MarchPurpose::search, typical_periods);
  const OrbitObservers observers = {
      [&](const StepRecord& record, const std::vector<LiveContact>& contacts) { output.step(record, contacts); },
      [&](const SearchPeriod& period) { output.end_search_period(period); }, run.checkpoint(), run.stop()};
  OrbitRun found;
  try {
    found = run_orbit(problem, films, mesh, guess, observers);
  } catch (const Unfinished&) {
    Summary summary = march_summary(problem, mesh, output.statistics());
    summary["completed"] = false;
    output.finish();
    write_summary(comm, run.directory().path(), summary);  // what was marched until then
    throw;
  }
  const double begin = found.orbit.begin, end = begin + mesh.path.mesh_period();
  output.file().attribute("/history", "periodic_from", begin);
  output.file().attribute("/history", "periodic_to", end);
  Summary summary = {{"case", problem.name},
                     {"nx", problem.numerics.nx},
                     {"ny", problem.numerics.ny},
                     {"dT", problem.numerics.steps.dT}};
  summary["static_force"] = problem.scales.operation.load;
  summary["mesh_period"] = problem.scales.time * mesh.path.mesh_period();
  summary.update(orbit_summary(mesh, found));
  summary["spectrum_peaks"] = output.write_spectrum(begin, end, SpectralWindow::none);
  summary["dry"] = dry_summary(problem, mesh);
  summary["completed"] = true;
  output.finish();
  write_summary(comm, run.directory().path(), summary);
  run.complete();
}

}  // namespace gearfilm

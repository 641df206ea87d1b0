#include "bench/bench_pair.hpp"

#include <algorithm>

#include "bench/yardstick.hpp"
#include "dynamics/march_statistics.hpp"
#include "input/case_setup.hpp"
#include "orbits/dry_orbit.hpp"
#include "output/screen.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr GridSize small = {129, 65}, large = {257, 257};

struct MeshPeriod {
  double seconds = 0.0;
  double unit = 0.0;  ///< a convolution's time, mean of those before and after it
  PeriodFigures figures;
};

/// The second mesh period of the lubricated pair from the dry periodic orbit shifted by the film: near the periodic
/// state.
MeshPeriod march_a_period(MPI_Comm comm, const CaseInput& problem, GridSize size) {
  CaseInput resized = problem;
  resized.numerics.nx = size.nx;
  resized.numerics.ny = size.ny;
  const SharedDiscretisation films = discretise(comm, resized);
  const MeshModel mesh = mesh_after_leaving(resized);
  const double mesh_period = mesh.path.mesh_period();
  MarchStatistics statistics(mesh_period, mesh.scales.static_force);
  MeshMarch march = make_march(resized, films, mesh, [&](const StepRecord& record, const std::vector<LiveContact>&) {
    statistics.add(record, given_figures(mesh, true));
  });
  march.start(dry_guess(orbit_problem(resized), films, dry_start(mesh)).motion);
  march.run(mesh_period);
  const double before = common_unit(comm, size), start = MPI_Wtime();
  march.run(2.0 * mesh_period);
  const double seconds = MPI_Wtime() - start;
  return {seconds, 0.5 * (before + common_unit(comm, size)), statistics.periods().back()};
}

Summary mesh_period_summary(MPI_Comm comm, const CaseInput& problem, GridSize size) {
  const auto [seconds, unit, period] = march_a_period(comm, problem, size);
  const double steps = period["steps"].value();
  const double newton = period["newton_iterations"].value() / steps;
  const double krylov = period["krylov_iterations"].value() / steps;
  const int contact_steps = static_cast<int>(period["contact_steps"].value());
  const double contact_step = period["wall_time"].value() / contact_steps / unit;
  petsc_check(PetscPrintf(comm,
                          "\nmesh period, %d x %d nodes, dT = %g: %.3g s; %d contact-steps of %.3g convolutions, %.2f "
                          "Newton and %.2f Krylov iterations a step\n",
                          size.nx, size.ny, problem.numerics.steps.dT, seconds, contact_steps, contact_step, newton,
                          krylov));
  return {{"nx", size.nx},
          {"ny", size.ny},
          {"dT", problem.numerics.steps.dT},
          {"seconds", seconds},
          {"contact_steps", contact_steps},
          {"newton_per_step", newton},
          {"krylov_per_step", krylov},
          {"contact_step_convolutions", contact_step}};
}

/// The whole of `gearfilm periodic`, results and all, in mesh periods of its own grid.
double periodic_job(MPI_Comm comm, const CaseInput& problem, const Job& run_periodic, double mesh_period_seconds) {
  CaseInput job = problem;
  job.run.directory /= "periodic";
  say(comm, "\nthe whole periodic job:");
  const double start = MPI_Wtime();
  run_periodic(comm, job);
  const double periods = (MPI_Wtime() - start) / mesh_period_seconds;
  say(comm, std::setprecision(3), "the job took ", periods, " of its mesh periods");
  return periods;
}

/// Speed of all processes together over that of one alone; and what the machine would allow: as many marches side by
/// side as there are processes.
Summary process_summary(MPI_Comm comm, const CaseInput& problem, GridSize size) {
  const int processes = processes_in(comm);
  double alone = rank_in(comm) == 0 ? march_a_period(PETSC_COMM_SELF, problem, size).seconds : 0.0;
  wait_asleep(comm);
  MPI_Bcast(&alone, 1, MPI_DOUBLE, 0, comm);
  double side_by_side = march_a_period(PETSC_COMM_SELF, problem, size).seconds;
  MPI_Allreduce(MPI_IN_PLACE, &side_by_side, 1, MPI_DOUBLE, MPI_MAX, comm);
  const double together = march_a_period(comm, problem, size).seconds;
  const double speedup = alone / together, limit = processes * alone / side_by_side;
  petsc_check(PetscPrintf(comm, "%d processes, %d x %d nodes: %.3g times as fast as one, the machine's limit is %.3g\n",
                          processes, size.nx, size.ny, speedup, limit));
  return {{"nx", size.nx}, {"ny", size.ny}, {"process_speedup", speedup}, {"process_limit", limit}};
}

}  // namespace

double common_unit(MPI_Comm comm, GridSize size) {
  double unit = convolution_time(size.nx, size.ny);
  MPI_Bcast(&unit, 1, MPI_DOUBLE, 0, comm);
  return unit;
}

/// A film that feels its heat, in the case's own oil or one that thins as oils do.
TractionModel warm_film(const CaseInput& problem) {
  constexpr double typical = 0.04;  // 1/K
  TractionModel model = problem.traction.value_or(TractionModel{});
  if (!model.heat) model.heat = HeatOptions{.oil = {.temperature_viscosity = typical}};
  model.heat->couple_film = true;
  return model;
}

Summary bench_pair(MPI_Comm comm, const CaseInput& problem, const Job& periodic) {
  CaseInput resized = problem;
  resized.numerics.nx = small.nx;
  resized.numerics.ny = small.ny;
  Summary summary;
  summary["mesh_period"] = mesh_period_summary(comm, resized, small);
  const double contact_step = summary["mesh_period"]["contact_step_convolutions"].get<double>();
  summary["contact_step_convolutions"] = contact_step;
  CaseInput warm = resized;
  warm.traction = warm_film(problem);
  warm.numerics.on_widening = widening_notice(warm.scales, contacts_at_a_time(warm), heated_points(warm));
  summary["thermal_mesh_period"] = mesh_period_summary(comm, warm, small);
  summary["thermal_contact_step_ratio"] =
      summary["thermal_mesh_period"]["contact_step_convolutions"].get<double>() / contact_step;
  summary["periodic_job_mesh_periods"] =
      periodic_job(comm, resized, periodic, summary["mesh_period"]["seconds"].get<double>());
  if (processes_in(comm) == 1) return summary;
  summary["processes"] = Summary::array();
  for (const GridSize size : {small, large}) summary["processes"].push_back(process_summary(comm, resized, size));
  for (const char* name : {"process_speedup", "process_limit"}) summary[name] = summary["processes"][0][name];
  return summary;
}

}  // namespace gearfilm

#include "bench/bench_pair.hpp"

#include <algorithm>

#include "bench/convolution_time.hpp"
#include "bench/kernel_time.hpp"
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
  PeriodQuantities quantities;
};

/// The second mesh period of the lubricated pair from the dry periodic orbit shifted by the film: near the periodic
/// state.
MeshPeriod march_a_period(MPI_Comm comm, const CaseInput& problem) {
  const GridSize size = size_of(problem);
  const SharedDiscretisation films = discretise(comm, problem);
  const MeshModel mesh = mesh_after_leaving(problem);
  const double mesh_period = mesh.path.mesh_period();
  MarchStatistics statistics(mesh_period, mesh.scales.static_force);
  MeshMarch march = make_march(problem, films, mesh, [&](const StepRecord& record, const std::vector<ActiveContact>&) {
    statistics.add(record, available_models(mesh, true));
  });
  march.start(dry_guess(orbit_problem(problem), films, dry_start(mesh)).motion);
  march.run(mesh_period);
  const double before = common_unit(comm, size), start = MPI_Wtime();
  march.run(2.0 * mesh_period);
  const double seconds = MPI_Wtime() - start;
  return {seconds, 0.5 * (before + common_unit(comm, size)), statistics.periods().back()};
}

/// Speed of a mesh period.
struct PeriodSpeed {
  GridSize size;
  double dT;
  MeshPeriod period;

  double steps() const { return period.quantities["steps"].value(); }
  int contact_steps() const { return static_cast<int>(period.quantities["contact_steps"].value()); }
  double newton() const { return period.quantities["newton_iterations"].value() / steps(); }
  double krylov() const { return period.quantities["krylov_iterations"].value() / steps(); }
  double contact_step() const { return period.quantities["wall_time"].value() / contact_steps() / period.unit; }
};

constexpr auto period_members = std::to_array<Member<PeriodSpeed>>({
    {"nx", "", "-", "nodes in X", [](const PeriodSpeed& of) -> Summary { return of.size.nx; }},
    {"ny", "", "-", "nodes in Y", [](const PeriodSpeed& of) -> Summary { return of.size.ny; }},
    {"dT", "dT", "-", "time step over a/u_m", [](const PeriodSpeed& of) -> Summary { return of.dT; }},
    {"seconds", "", "s", "time it took", [](const PeriodSpeed& of) -> Summary { return of.period.seconds; }},
    {"contact_steps", "", "-", "time steps of contacts, each counted by itself",
     [](const PeriodSpeed& of) -> Summary { return of.contact_steps(); }},
    {"newton_per_step", "", "-", "iterations of Newton's method a step",
     [](const PeriodSpeed& of) -> Summary { return of.newton(); }},
    {"krylov_per_step", "", "-", "iterations of the linear solver a step",
     [](const PeriodSpeed& of) -> Summary { return of.krylov(); }},
    {"contact_step_convolutions", "", "-", "time of a contact-step in convolution times of its grid",
     [](const PeriodSpeed& of) -> Summary { return of.contact_step(); }},
});

PeriodSpeed mesh_period_speed(MPI_Comm comm, const CaseInput& problem, const char* films) {
  const GridSize size = size_of(problem);
  const PeriodSpeed speed{size, problem.numerics.steps.dT, march_a_period(comm, problem)};
  petsc_check(
      PetscPrintf(comm,
                  "\nmesh period, %s, %d x %d nodes, dT = %g: %.3g s; %d contact-steps of %.3g convolutions, %.2f "
                  "Newton and %.2f Krylov iterations a step\n",
                  films, size.nx, size.ny, speed.dT, speed.period.seconds, speed.contact_steps(), speed.contact_step(),
                  speed.newton(), speed.krylov()));
  return speed;
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
struct ProcessSpeed {
  GridSize size;
  double speedup, limit;
};

constexpr auto process_members = std::to_array<Member<ProcessSpeed>>({
    {"nx", "", "-", "nodes in X", [](const ProcessSpeed& of) -> Summary { return of.size.nx; }},
    {"ny", "", "-", "nodes in Y", [](const ProcessSpeed& of) -> Summary { return of.size.ny; }},
    {"process_speedup", "", "-", "speed of all processes together over that of one",
     [](const ProcessSpeed& of) -> Summary { return of.speedup; }},
    {"process_limit", "", "-", "the same of as many marches side by side: what the machine allows",
     [](const ProcessSpeed& of) -> Summary { return of.limit; }},
});

ProcessSpeed process_speed(MPI_Comm comm, const CaseInput& problem) {
  const GridSize size = size_of(problem);
  const int processes = processes_in(comm);
  double alone = rank_in(comm) == 0 ? march_a_period(PETSC_COMM_SELF, problem).seconds : 0.0;
  wait_asleep(comm);
  MPI_Bcast(&alone, 1, MPI_DOUBLE, 0, comm);
  double side_by_side = march_a_period(PETSC_COMM_SELF, problem).seconds;
  MPI_Allreduce(MPI_IN_PLACE, &side_by_side, 1, MPI_DOUBLE, MPI_MAX, comm);
  const double together = march_a_period(comm, problem).seconds;
  const ProcessSpeed speed{size, alone / together, processes * alone / side_by_side};
  petsc_check(PetscPrintf(comm, "%d processes, %d x %d nodes: %.3g times as fast as one, the machine's limit is %.3g\n",
                          processes, size.nx, size.ny, speed.speedup, speed.limit));
  return speed;
}

}  // namespace

GridSize size_of(const CaseInput& problem) { return {problem.numerics.nx, problem.numerics.ny}; }

CaseInput on_grid(const CaseInput& problem, GridSize size) {
  CaseInput resized = problem;
  resized.numerics.nx = size.nx;
  if (!problem.numerics.face_rows && !problem.scales.solids.line) resized.numerics.ny = size.ny;
  return resized;
}

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
  const CaseInput resized = on_grid(problem, small);
  const PeriodSpeed speed = mesh_period_speed(comm, resized, "films of the case");
  CaseInput warm = resized;
  warm.traction = warm_film(problem);
  warm.numerics.on_widening = widening_notice(warm.scales, contacts_at_a_time(warm), heated_points(warm));
  const PeriodSpeed thermal = mesh_period_speed(comm, warm, "films that feel their heat");
  Summary summary;
  summary["mesh_period"] = as_summary(period_members, speed);
  summary["contact_step_convolutions"] = speed.contact_step();
  summary["thermal_mesh_period"] = as_summary(period_members, thermal);
  summary["thermal_contact_step_ratio"] = thermal.contact_step() / speed.contact_step();
  summary["periodic_job_mesh_periods"] = periodic_job(comm, resized, periodic, speed.period.seconds);
  if (processes_in(comm) == 1) return summary;
  const ProcessSpeed first = process_speed(comm, resized);
  summary["processes"] = {as_summary(process_members, first),
                          as_summary(process_members, process_speed(comm, on_grid(problem, large)))};
  summary["process_speedup"] = first.speedup;
  summary["process_limit"] = first.limit;
  return summary;
}

std::string bench_markdown() {
  return members_markdown("Kernels of `bench`", "Keys of each of the `rows` of each of its `grids`.", kernel_members) +
         members_markdown("A mesh period of `bench`",
                          "Keys of `mesh_period`, and of `thermal_mesh_period` on films that feel their heat.",
                          period_members) +
         members_markdown("Processes", "Keys of each of the `processes` of `bench`, on 129 x 65 and 257 x 257 nodes.",
                          process_members);
}

}  // namespace gearfilm

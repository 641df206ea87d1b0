// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include "gearfilm/app/case_setup.hpp"
#include "gearfilm/app/commands.hpp"
#include "gearfilm/app/march_output.hpp"
#include "gearfilm/dynamics/natural_frequency.hpp"
#include "gearfilm/dynamics/periodic_orbit.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/io/output_directory.hpp"

namespace gearfilm {
namespace {

constexpr double usual_periods = 6.0;  // for the time left

Summary multiplier_list(const Monodromy& monodromy) {
  Summary list = Summary::array();
  for (const std::complex<double>& multiplier : multipliers(monodromy)) {
    list.push_back({multiplier.real(), multiplier.imag()});
  }
  return list;
}

void add_oscillation(const Case& problem, const Monodromy& monodromy, Summary& summary) {
  const double f_m = mesh_frequency(*problem.gears, problem.pinion_speed);
  const double f_n = natural_frequency(contact_stiffness(problem.scales.operation.load, problem.scales.hertz),
                                       *problem.equivalent_mass);
  const FreeOscillation oscillation = free_oscillation(multipliers(monodromy), f_m, f_n);
  summary["floquet"] = multiplier_list(monodromy);
  summary["floquet_modulus"] = std::abs(multipliers(monodromy)[0]);
  summary["free_frequency"] = oscillation.frequency;
  summary["damping_ratio"] = oscillation.damping_ratio;
}

Summary orbit_summary(const Case& problem, const PeriodicOrbit& orbit, const PeriodFigures& period) {
  const Scales& scales = problem.scales;
  Summary summary = {{"case", problem.name}, {"nx", problem.nx}, {"ny", problem.ny}, {"dT", problem.steps.dT}};
  summary["periods_used"] = orbit.periods_used;
  summary["defect"] = orbit.defect;
  summary["film_defect"] = orbit.film_defect;
  summary["H0_after_leaving"] = orbit.start.motion.H0;
  summary["V0_after_leaving"] = orbit.start.motion.V0;
  summary.update(period_summary(scales, period));
  if (problem.periodic.with_multipliers) add_oscillation(problem, orbit.monodromy, summary);
  Summary dry = {{"H0_after_leaving", orbit.dry.start.H0},
                 {"V0_after_leaving", orbit.dry.start.V0},
                 {"force_ratio_max", orbit.dry.largest_integral / scales.static_force}};
  add_oscillation(problem, orbit.dry.monodromy, dry);
  summary["dry"] = std::move(dry);
  return summary;
}

}  // namespace

void run_periodic(MPI_Comm comm, const Case& problem) {
  require_inertia(problem);
  const Grid grid(comm, case_grid(problem));
  prepare_output_directory(comm, problem.output_directory);
  remove_earlier_results(comm, problem.output_directory);
  const ContactPath path = path_after_leaving(problem);
  const double inertia = problem.scales.inertia(*problem.equivalent_mass);
  const DryOrbit dry = find_dry_orbit(problem.scales, path, inertia);
  const double film_shift = stationary_film_shift(problem, grid);
  MarchOutput output(comm, problem, grid, path, true, "periodic", usual_periods);
  MeshMarch march = make_march(problem, grid, path, output.observer());
  const auto summary_file = problem.output_directory / "summary.json";
  PeriodicOrbit orbit;
  try {
    orbit = find_periodic_orbit(march, path, dry, film_shift, problem.periodic, [&](const SearchPeriod& p) {
      petsc_check(PetscPrintf(comm, "period %d: start %.5f %.5f end %.5f %.5f defect %.2e %.2e film %.2e\n", p.number, p.start.H0, p.start.V0, p.end.H0, p.end.V0, p.end.H0-p.start.H0, p.end.V0-p.start.V0, p.film_defect));
    });
  } catch (const SolveError&) {
    Summary summary = march_summary(problem, path, output.statistics());
    summary["completed"] = false;
    write_summary(comm, summary_file, summary);  // what was marched until then
    throw;
  }
  output.file().attribute("/history", "periodic_from", orbit.begin);
  output.file().attribute("/history", "periodic_to", orbit.begin + path.mesh_period());
  const PeriodFigures& period = output.statistics().periods().at(orbit.periods_used - 1);
  Summary summary = orbit_summary(problem, orbit, period);
  summary["completed"] = true;
  write_summary(comm, summary_file, summary);
}

}  // namespace gearfilm

// `gearfilm periodic`: the periodic state of the lubricated pair by shooting, with its Floquet multipliers.
#include <cmath>

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

/// The undamped dry pair's orbit, for comparison; nothing where there is none.
Summary dry_summary(const Case& problem, const ContactPath& path) {
  try {
    const DryOrbit dry = find_dry_orbit(problem.scales, path, problem.scales.inertia(*problem.equivalent_mass), 0.0);
    Summary summary = {{"H0_after_leaving", dry.start.H0},
                       {"V0_after_leaving", dry.start.V0},
                       {"force_ratio_max", dry.largest_integral / problem.scales.static_force}};
    add_oscillation(problem, dry.monodromy, summary);
    return summary;
  } catch (const SolveError&) {
    return nullptr;
  }
}

Summary orbit_summary(const Case& problem, const ContactPath& path, const PeriodicOrbit& orbit,
                      const PeriodFigures& period) {
  Summary summary = {{"case", problem.name}, {"nx", problem.nx}, {"ny", problem.ny}, {"dT", problem.steps.dT}};
  summary["periods_used"] = orbit.periods_used;
  summary["defect"] = orbit.defect;
  summary["film_defect"] = orbit.film_defect;
  summary["H0_after_leaving"] = orbit.start.motion.H0;
  summary["V0_after_leaving"] = orbit.start.motion.V0;
  summary.update(period_summary(problem.scales, period));
  if (problem.periodic.with_multipliers) add_oscillation(problem, orbit.monodromy, summary);
  summary["dry"] = dry_summary(problem, path);
  return summary;
}

}  // namespace

void run_periodic(MPI_Comm comm, const Case& problem) {
  require_inertia(problem);
  const Grid grid(comm, case_grid(problem));
  prepare_output_directory(comm, problem.output_directory);
  remove_earlier_results(comm, problem.output_directory);
  const ContactPath path = path_after_leaving(problem);
  const OrbitGuess guess = dry_guess(problem, grid, path);
  MarchOutput output(comm, problem, grid, path, true, "periodic", usual_periods);
  MeshMarch march = make_march(problem, grid, path, output.observer());
  const auto summary_file = problem.output_directory / "summary.json";
  PeriodicOrbit orbit;
  try {
    orbit = find_periodic_orbit(march, path, guess, problem.periodic, [&](const SearchPeriod& period) {
      petsc_check(PetscPrintf(comm, "mesh period %d: (H0, V0) repeats within %.1e, the films within %.1e\n",
                              period.number, period.defect, period.film_defect));
    });
  } catch (const SolveError&) {
    Summary summary = march_summary(problem, path, output.statistics());
    summary["completed"] = false;
    write_summary(comm, summary_file, summary);  // what was marched until then
    throw;
  }
  output.file().attribute("/history", "periodic_from", orbit.begin);
  output.file().attribute("/history", "periodic_to", orbit.begin + path.mesh_period());
  const auto index = static_cast<std::size_t>(std::lround(orbit.begin / path.mesh_period()));
  Summary summary = orbit_summary(problem, path, orbit, output.statistics().periods().at(index));
  summary["completed"] = true;
  write_summary(comm, summary_file, summary);
}

}  // namespace gearfilm

#include "results/orbit_summary.hpp"

#include "results/error_bar.hpp"
#include "results/friction_summary.hpp"
#include "results/march_summary.hpp"

namespace gearfilm {

void add_multipliers(const MeshModel& mesh, const Multipliers& pair, Summary& summary) {
  const std::optional<FreeOscillation> oscillation =
      free_oscillation(pair, mesh.mesh_frequency_si() / mesh.periods(), mesh.frequency_si());
  summary["floquet"] = pair;
  const double modulus = largest_modulus(pair);
  summary["floquet_modulus"] = modulus;
  summary["stable"] = modulus < 1.0;
  summary["free_frequency"] = oscillation ? Summary(oscillation->frequency) : Summary();
  summary["damping_ratio"] = oscillation ? Summary(oscillation->damping_ratio) : Summary();
}

Summary orbit_summary(const MeshModel& mesh, const DescribedOrbit& found) {
  const Scales& scales = mesh.scales;
  const PeriodicOrbit& orbit = found.orbit;
  Summary summary;
  summary["periods_used"] = orbit.periods_used;
  const bool lubricated = !orbit.end.films.empty();
  if (lubricated) summary["final_grid"] = grid_summary(scales, orbit.end.shape);
  summary["defect"] = orbit.defect;
  if (lubricated) summary["film_defect"] = orbit.film_defect;
  summary["states_after_leaving"] = found.states_after_leaving;
  summary["H0_after_leaving"] = orbit.start.motion.H0();
  summary["V0_after_leaving"] = orbit.start.motion.V0();
  summary.update(period_summary(scales, found.figures));
  summary["contact_lost"] = found.contact_lost;
  summary["back_contact"] = found.figures["back_force_ratio_max"].value_or(0.0) > 0.0;
  summary["transmission_error_peak_to_peak"] = scales.thickness * found.transmission_error.peak_to_peak;
  summary["transmission_error_rms"] = scales.thickness * found.transmission_error.root_mean_square;
  if (found.decay) {
    add_multipliers(mesh, found.decay->multipliers, summary);
    summary["floquet_modulus_error"] = found.decay->modulus_error;
  }
  return summary;
}

void add_errors(const std::vector<OrbitError>& errors, const Scales& scales, Summary& summary) {
  for (const OrbitError& error : errors) add_error_bar(summary, error.name, error.in_si(scales));
}

Summary periodic_summary(const CaseInput& problem, const MeshModel& mesh, const FoundOrbit& found,
                         const std::vector<OrbitError>& errors) {
  Summary summary = {{"case", problem.name},
                     {"nx", problem.numerics.nx},
                     {"ny", problem.numerics.ny},
                     {"dT", problem.numerics.steps.dT}};
  summary["motion"] = problem.parameters.text("motion");
  summary["order"] = problem.search.order;
  summary["static_force"] = problem.scales.operation.load;
  summary["mesh_period"] = problem.scales.time * mesh.path.mesh_period();
  summary.update(orbit_summary(mesh, found.own));
  add_errors(errors, mesh.scales, summary);
  add_efficiency(mesh, summary);
  return summary;
}

Summary dry_summary(const MeshModel& mesh) {
  constexpr double most_oscillations = 10.0;
  if (mesh.inertia == 0.0 || mesh.periods() > 1 || mesh.frequency() * mesh.path.mesh_period() > most_oscillations)
    return nullptr;
  const std::optional<DryOrbit> dry = find_dry_orbit_soon(mesh, 0.0);
  if (!dry) return nullptr;
  Summary summary = {{"H0_after_leaving", dry->start.H0()},
                     {"V0_after_leaving", dry->start.V0()},
                     {"force_ratio_max", dry->largest_integral / mesh.scales.static_force}};
  add_multipliers(mesh, multipliers(dry->monodromy), summary);
  for (const char* noise : {"stable", "damping_ratio"}) summary.erase(noise);  // without damping
  return summary;
}

}  // namespace gearfilm

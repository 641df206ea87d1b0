#include "app/orbit_summary.hpp"

#include "app/error_bar.hpp"
#include "app/march_output.hpp"

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

}  // namespace gearfilm

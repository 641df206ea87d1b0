#include "gearfilm/app/friction_summary.hpp"

#include <numbers>
#include <sstream>

#include "gearfilm/app/warning.hpp"
#include "gearfilm/contact/friction_formulas.hpp"

namespace gearfilm {

Summary heating_predictions(const Case& problem, const ContactSolids& solids, const ContactOperation& operation,
                            double slide_ratio) {
  if (!problem.thermal_oil) return Summary::object();
  const ThermalOil& oil = *problem.thermal_oil;
  const double loading = thermal_loading(oil.temperature_viscosity, problem.scales.oil.viscosity,
                                         operation.entrainment_velocity, oil.conductivity);
  const double relative = hertz_contact(solids, operation.load).pressure / solids.reduced_modulus;
  return {{"thermal_loading", loading},
          {"murch_wilson_thermal_factor", murch_wilson_factor(loading)},
          {"gupta_thermal_factor", gupta_factor(loading, relative, slide_ratio)}};
}

Summary heating_at_pitch(const Case& problem) {
  return heating_predictions(problem, problem.scales.solids, problem.scales.operation, 0.0);
}

Summary friction_predictions(const Case& problem, const ContactSolids& solids, const ContactOperation& operation,
                             const SurfaceVelocities& velocities, double friction_coefficient) {
  constexpr double usual_roughness = 0.4e-6;  // where none is given [m]
  Summary summary = Summary::object();
  if (!problem.traction) return summary;
  const double roughness = problem.roughness.value_or(usual_roughness), viscosity = problem.scales.oil.viscosity;
  const HertzContact hertz = hertz_contact(solids, operation.load);
  const double slide_ratio = velocities.sliding / velocities.mean;
  summary["xu_kahraman_friction"] =
      xu_kahraman_friction(hertz.pressure, slide_ratio, velocities.mean, viscosity, solids.radius_x, roughness);
  // On the middle line of the ellipse: Int p dx = pi/2 p_h a.
  const double line_load = 0.5 * std::numbers::pi * hertz.pressure * hertz.a;
  summary["blok_flash_temperature"] =
      blok_flash_temperature(friction_coefficient * line_load, velocities.pinion(), velocities.wheel(),
                             problem.traction->bodies[0].effusivity(), hertz.a);
  if (problem.pair.line) {
    const LineOfAction& line = *problem.pair.line;
    const double tooth_force = problem.pair.torque / line.base_radius_pinion();
    summary["schlenk_mean_friction"] = schlenk_friction(tooth_force / problem.pair.gears->face_width,
                                                        2.0 * line.entrainment_velocity(0.0, problem.pair.pinion_speed),
                                                        line.radius_x(0.0), viscosity, roughness);
  }
  return summary;
}

void warn_of_heating(MPI_Comm comm, const Case& problem, const Summary& heating) {
  constexpr double tolerable = 0.8;
  if (problem.traction && problem.traction->heats_film()) return;
  if (!heating.contains("murch_wilson_thermal_factor")) return;
  const double factor = heating["murch_wilson_thermal_factor"].get<double>();
  if (factor >= tolerable) return;
  std::ostringstream text;
  text.precision(2);
  text << "the film is computed as if its inlet were not heated by shear; Murch and Wilson's factor for that is "
       << factor << ", so that it may be thinner by " << 100.0 * (1.0 - factor)
       << " %; -thermal_model film computes it";
  warn(comm, text.str());
}

void warn_of_missed_temperatures(MPI_Comm comm, const Summary& summary, const char* missed) {
  constexpr double tolerable = 0.01;
  if (!summary.contains(missed) || summary[missed].get<double>() <= tolerable) return;
  std::ostringstream text;
  text.precision(2);
  text << "in " << 100.0 * summary[missed].get<double>()
       << " % of a contact's nodes the temperature across the film did not settle; raise thermal.points";
  warn(comm, text.str());
}

void warn_of_roughness(MPI_Comm comm, const Summary& summary, const char* film_ratio) {
  if (!summary.contains(film_ratio) || summary[film_ratio].get<double>() >= 1.0) return;
  std::ostringstream text;
  text.precision(2);
  text << "the smallest film is " << summary[film_ratio].get<double>()
       << " of the roughness: asperities touch, which is not modelled";
  warn(comm, text.str());
}

void add_efficiency(const MeshModel& mesh, Summary& summary) {
  // One contact of a prescribed share is not a mesh.
  if (!summary.contains("power_loss") || mesh.load) return;
  const double transmitted = mesh.transmitted_power();
  summary["transmitted_power"] = transmitted;
  summary["efficiency"] = 1.0 - summary["power_loss"].get<double>() / transmitted;
  summary["loss_factor"] = mesh.path.line().loss_factor();
  summary["mean_friction_coefficient"] =
      summary["power_sliding"].get<double>() / (mesh.path.line().loss_factor() * transmitted);
}

}  // namespace gearfilm

#include "results/friction_summary.hpp"

#include <numbers>

#include "contact/friction_formulas.hpp"

namespace gearfilm {

namespace {

/// The oil's heat data, with an assumed fall of its viscosity where none is given.
ThermalOil heating_oil(const CaseInput& problem) {
  if (problem.thermal_oil) return *problem.thermal_oil;
  return {.temperature_viscosity = assumed_temperature_viscosity,
          .conductivity = problem.parameters.real("lubricant.conductivity")};
}

}  // namespace

Summary heating_predictions(const CaseInput& problem, const ContactSolids& solids, const ContactOperation& operation,
                            double slide_ratio) {
  const ThermalOil oil = heating_oil(problem);
  const double loading = thermal_loading(oil.temperature_viscosity, problem.scales.oil.viscosity,
                                         operation.entrainment_velocity, oil.conductivity);
  const double relative = hertz_contact(solids, operation.load).pressure / solids.reduced_modulus;
  return {{"thermal_loading", loading},
          {"murch_wilson_thermal_factor", murch_wilson_factor(loading)},
          {"gupta_thermal_factor", gupta_factor(loading, relative, slide_ratio)}};
}

Summary heating_at_pitch(const CaseInput& problem) {
  return heating_predictions(problem, problem.scales.solids, problem.scales.operation, 0.0);
}

Summary friction_predictions(const CaseInput& problem, const ContactSolids& solids, const ContactOperation& operation,
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

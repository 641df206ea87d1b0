#include "results/derived.hpp"

#include <cmath>
#include <numbers>

#include "contact/film_formulas.hpp"
#include "gear/tooth_space.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "mesh/static_mesh.hpp"
#include "results/friction_summary.hpp"

namespace gearfilm {
namespace {

void add_gear_geometry(const CaseInput& problem, Summary& summary) {
  const LineOfAction& line = *problem.pair.line;
  summary["working_pressure_angle_deg"] = line.working_pressure_angle() * 180.0 / std::numbers::pi;
  summary["base_radius_pinion"] = line.base_radius_pinion();
  summary["base_radius_wheel"] = line.base_radius_wheel();
  summary["base_pitch"] = line.base_pitch();
  summary["xi_entry"] = line.entry();
  summary["xi_exit"] = line.exit();
  summary["contact_ratio"] = line.contact_ratio();
  const ToothSpace space = tooth_space(*problem.pair.gears);
  if (space.implied_backlash) summary["implied_backlash"] = *space.implied_backlash;
}

void add_mesh_motion(const CaseInput& problem, Summary& summary) {
  const double f_m = mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed);
  summary["f_m"] = f_m;
  summary["mesh_period"] = 1.0 / f_m;
  summary["mesh_period_dimensionless"] = mesh_period(problem);
  // A point load that stands for a line contact is no force of the pair.
  if (problem.parameters.text("gear.load_model") != "point") return;
  const MeshModel mesh = mesh_after_leaving(problem);
  if (const std::optional<double> met = entry_penetration(mesh, mesh.scales.static_force)) {
    summary["entry_penetration"] = *met * mesh.scales.thickness;
    if (*met > 0.0) summary["corner_contact_distance"] = corner_distance(mesh, *met);
  }
  if (!problem.pair.equivalent_mass) return;
  summary["m_ge"] = *problem.pair.equivalent_mass;
  summary["I_n"] = problem.scales.inertia(*problem.pair.equivalent_mass);
  summary["k_el"] = mesh.stiffness_si();
  summary["f_n"] = natural_frequency(mesh.stiffness_si(), *problem.pair.equivalent_mass);
}

/// The grid and the step that a run would begin with, and what is to be expected of films on them.
void add_numerics(const CaseInput& problem, Summary& summary) {
  const PairNumerics& numerics = problem.numerics;
  const Domain& domain = numerics.domain;
  summary["nx"] = numerics.nx;
  summary["ny"] = numerics.ny;
  summary["x_min"] = domain.x_min;
  summary["x_max"] = domain.x_max;
  summary["y_half"] = domain.y_half;
  const FilmErrors errors = expected_errors(numerics.discretisation, ExpectedFilm(problem.scales), steps_of(numerics));
  summary["expected_error_h_central"] = errors.central;
  if (std::isfinite(errors.smallest)) summary["expected_error_h_min"] = errors.smallest;
  if (!problem.pair.line) return;
  summary["dT"] = numerics.steps.dT;
  summary["steps_in_mesh_period"] = mesh_period(problem) / numerics.steps.dT;
  if (problem.pair.equivalent_mass) {
    summary["steps_in_free_oscillation"] = natural_period(problem) / numerics.steps.dT;
  }
}

}  // namespace

Summary film_predictions(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  return {{"hamrock_dowson_h_central", hamrock_dowson_central(solids, oil, operation)},
          {"hamrock_dowson_h_min", hamrock_dowson_minimum(solids, oil, operation)},
          {"nijenbanning_venner_moes_h_central", nijenbanning_venner_moes_central(solids, oil, operation)}};
}

Summary derived_quantities(const CaseInput& problem) {
  const Scales& scales = problem.scales;
  const MoesGroups groups = moes_groups(scales.solids, scales.oil, scales.operation);
  Summary summary;
  summary["case"] = problem.name;
  if (problem.pair.line) add_gear_geometry(problem, summary);
  summary["R_x"] = scales.solids.radius_x;
  summary["R_y"] = scales.solids.radius_y;
  summary["E_prime"] = scales.solids.reduced_modulus;
  summary["load"] = scales.operation.load;
  if (problem.pair.line) summary["tooth_force"] = problem.pair.tooth_force;
  summary["entrainment_velocity"] = scales.operation.entrainment_velocity;
  summary["kappa"] = scales.hertz.ellipticity;
  summary["a"] = scales.hertz.a;
  summary["b"] = scales.hertz.b;
  summary["p_hertz"] = scales.hertz.pressure;
  summary["hertz_approach"] = scales.hertz.approach;
  summary["M"] = groups.M;
  summary["L"] = groups.L;
  summary["D"] = groups.D;
  if (problem.pair.line) add_mesh_motion(problem, summary);
  summary.update(film_predictions(scales.solids, scales.oil, scales.operation));
  summary.update(heating_at_pitch(problem));
  add_numerics(problem, summary);
  return summary;
}

}  // namespace gearfilm

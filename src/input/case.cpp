#include "input/case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/moes.hpp"
#include "elasticity/row_contact.hpp"
#include "gear/tooth_space.hpp"
#include "gearfilm/error.hpp"
#include "input/case_checks.hpp"
#include "input/case_face.hpp"
#include "input/case_fatigue.hpp"
#include "input/case_file.hpp"
#include "input/case_lubricant.hpp"
#include "input/case_numerics.hpp"
#include "input/case_rating.hpp"
#include "input/case_roughness.hpp"
#include "input/case_setup.hpp"
#include "input/case_stress.hpp"
#include "input/case_teeth.hpp"
#include "input/case_tilt.hpp"
#include "input/case_topography.hpp"
#include "input/case_traction.hpp"
#include "input/plain_text.hpp"
#include "input/point_table.hpp"
#include "mesh/static_mesh.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

SpurGear read_gear(const ParameterValues& values, const std::string& gear) {
  return {.teeth = values.integer(gear + ".teeth"),
          .outer_radius = values.real(gear + ".outer_radius"),
          .crowning = values.real(gear + ".crowning"),
          .youngs_modulus = values.real(gear + ".youngs_modulus"),
          .poisson_ratio = values.real(gear + ".poisson_ratio"),
          .profile_shift = values.real_if_given(gear + ".profile_shift"),
          .root_radius = values.real_if_given(gear + ".root_radius"),
          .hob_tip_radius = values.real_if_given(gear + ".hob_tip_radius"),
          .bore_radius = values.real_if_given(gear + ".bore_radius")};
}

SpurGearPair read_gear_pair(const ParameterValues& values) {
  return {.pinion = read_gear(values, "pinion"),
          .wheel = read_gear(values, "wheel"),
          .module_length = values.real("gear.module"),
          .pressure_angle = values.real("gear.pressure_angle_deg") * pi / 180.0,
          .centre_distance = values.real("gear.centre_distance"),
          .face_width = values.real("gear.face_width"),
          .backlash = values.real_if_given("gear.backlash")};
}

// Either both inertias or the mass itself; none for a pair that does not vibrate.
std::optional<double> read_equivalent_mass(const ParameterValues& values, const LineOfAction& line) {
  const std::string mass = "gear.equivalent_mass", pinion = "pinion.inertia", wheel = "wheel.inertia";
  for (const std::string& known : {pinion, wheel}) {
    values.require_not_both(known, mass, ", and each says how heavy the gears are; delete one");
  }
  values.require_both(pinion, wheel, "give both inertias, " + in_quotes(mass) + ", or neither");
  if (values.has(mass)) return values.real(mass);
  if (values.has(pinion)) return equivalent_mass(line, values.real(pinion), values.real(wheel));
  return {};
}

ContactSolids solids_at_pitch(const ParameterValues& values, const LineOfAction& line) {
  return {.radius_x = line.radius_x(0.0),
          .radius_y = line.radius_y(),
          .reduced_modulus = reduced_modulus(values.real("pinion.youngs_modulus"), values.real("pinion.poisson_ratio"),
                                             values.real("wheel.youngs_modulus"), values.real("wheel.poisson_ratio"))};
}

// w* = T_g1/R_b1, or its equivalent point load (27).
double reference_load(const CaseInput& gear_case, const ContactSolids& solids) {
  const double tooth_force = gear_case.pair.tooth_force;
  if (gear_case.parameters.text("gear.load_model") == "point") return tooth_force;
  const double face_width = gear_case.pair.gears->face_width;
  return equivalent_point_load(
      solids, hertz_line_half_width(tooth_force / face_width, solids.radius_x, solids.reduced_modulus));
}

/// What touches at the pitch point of a gear pair, or in a bare contact.
struct ReferenceContact {
  ContactSolids solids;
  ContactOperation operation;
};

ReferenceContact set_gear_pair(CaseInput& result, const Lubricant& oil, const WornFlanks& worn) {
  const ParameterValues& values = result.parameters;
  result.pair.gears = read_gear_pair(values);
  result.pair.line = in_file_of(values, [&] { return LineOfAction(*result.pair.gears); });
  in_file_of(values, [&] { check_tooth_space(*result.pair.gears, *result.pair.line); });
  result.pair.teeth =
      in_file_of(values, [&] { return read_teeth(values, *result.pair.gears, *result.pair.line, worn); });
  result.pair.pinion_speed = values.real("pinion.speed_rpm") * 2.0 * pi / 60.0;
  result.pair.torque = values.real("pinion.torque");
  result.pair.tooth_force = result.pair.torque / result.pair.line->base_radius_pinion();
  result.pair.equivalent_mass = read_equivalent_mass(values, *result.pair.line);
  if (values.has("pinion.inertia")) {
    result.pair.inertias = {values.real("pinion.inertia"), values.real("wheel.inertia")};
  }
  result.pair.train = read_train(values, *result.pair.line);
  ContactSolids solids = solids_at_pitch(values, *result.pair.line);
  set_face(values, face_under_load(values, result.pair, solids, oil), result.pair.tooth_force, solids);
  const std::string load_model = "gear.load_model";
  if (solids.face && values.text(load_model) != "point") {
    values.refuse(load_model, "is " + values.text(load_model) +
                                  ", but the contact reaches the ends of the face or feels their shape, and no point "
                                  "load stands for it; set it to point");
  }
  return {solids, in_file_of(values, [&] {
            return ContactOperation{
                .load = reference_load(result, solids),
                .entrainment_velocity = result.pair.line->entrainment_velocity(0.0, result.pair.pinion_speed)};
          })};
}

double read_reduced_modulus(const ParameterValues& values) {
  const std::array<std::string, 4> bodies = {"contact.youngs_modulus_1", "contact.poisson_ratio_1",
                                             "contact.youngs_modulus_2", "contact.poisson_ratio_2"};
  const std::string reduced = "contact.reduced_modulus";
  for (const std::string& body : bodies) {
    values.require_not_both(body, reduced, "; delete one");
    if (!values.has(reduced) && !values.has(body))
      throw InputError(values.file() + ": " + in_quotes(body) + " is missing; give " + in_quotes(reduced) +
                       ", or Young's modulus and Poisson's ratio of both bodies");
  }
  if (values.has(reduced)) return values.real(reduced);
  return reduced_modulus(values.real(bodies[0]), values.real(bodies[1]), values.real(bodies[2]),
                         values.real(bodies[3]));
}

ReferenceContact read_bare_contact(const ParameterValues& values) {
  const bool line = values.text("case.kind") == "line";
  const std::string radius_y = "contact.radius_y", width = "contact.face_width";
  if (!line && !values.has(radius_y) && !values.has(width)) {
    throw InputError(values.file() + ": " + in_quotes(radius_y) + " is missing; give it, or " + in_quotes(width) +
                     " of a contact without crowning");
  }
  ContactSolids solids{.radius_x = values.real("contact.radius_x"),
                       .radius_y = line ? HUGE_VAL : values.real_if_given(radius_y).value_or(HUGE_VAL),
                       .reduced_modulus = read_reduced_modulus(values),
                       .line = line};
  if (!line) set_face(values, read_face_of_contact(values), values.real("contact.load"), solids);
  return {.solids = solids,
          .operation = {.load = values.real(line ? "contact.line_load" : "contact.load"),
                        .entrainment_velocity = values.real("contact.entrainment_velocity")}};
}

// The folder of the results is named after the case.
std::string read_name(const ParameterValues& values) {
  const std::string& name = values.text("case.name");
  if (name.find('/') == std::string::npos && name != "." && name != "..") return name;
  values.refuse("case.name",
                "is '" + name + "', which is no name of a folder; give a word without '/', and folders as output.dir");
}

// A position on the line of action, which a bare contact has not.
double read_position(const CaseInput& result, const std::string& name) {
  const double position = result.parameters.real(name);
  const std::string given =
      result.parameters.origin(name) + ": " + in_quotes(name) + " is " + format_value(position) + " m";
  if (!result.pair.line) {
    if (position != 0.0) throw InputError(given + ", but a bare contact has no line of action; delete the key");
    return position;
  }
  const double entry = result.pair.line->entry(), exit = result.pair.line->exit();
  if (position < entry || position > exit)
    throw InputError(given + ", off the path of contact; give a number in [" + format_value(entry) + ", " +
                     format_value(exit) + "] m");
  return position;
}

// Where the march starts; just after a leaving the remaining contact sits one base pitch before the exit.
double read_start_position(const CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const std::string& place = values.text("start.place");
  const std::string position = "start.position";
  if (place == "position" && values.has(position)) return read_position(result, position);
  if (values.has(position)) {
    values.refuse(position,
                  "is given, but 'start.place' is " + place + "; set start.place to position or delete the key");
  }
  if (place == "after_leaving") return result.pair.line->exit() - result.pair.line->base_pitch();
  return 0.0;
}

std::optional<Motion> read_start_motion(const ParameterValues& values) {
  if (values.has("start.H0")) return Motion{values.real("start.H0"), values.real_if_given("start.V0").value_or(0.0)};
  if (!values.has("start.V0")) return {};
  values.refuse("start.V0", "is given without 'start.H0'; give both or neither");
}

// An interval shorter than a step stores every step; the next time must not be lost in round-off, though.
void check_snapshot_interval(const CaseInput& result) {
  constexpr double shortest = 1e-9;
  if (result.march.snapshot_interval.value_or(0.0) == 0.0 || *result.march.snapshot_interval >= shortest) return;
  result.parameters.refuse("output.snapshot_interval", "is " + format_value(*result.march.snapshot_interval) +
                                                           " mesh periods, far shorter than any time step; give 0 for "
                                                           "no fields, or at least " +
                                                           format_value(shortest));
}

MarchModel read_model(const std::string& name) {
  if (name == "simplified") return MarchModel::simplified;
  if (name == "quasistatic") return MarchModel::quasistatic;
  return name == "dry" ? MarchModel::dry : MarchModel::dynamic;
}

PairMotion read_motion(const CaseInput& result) {
  const ParameterValues& values = result.parameters;
  if (values.text("motion") == "dynamic") return PairMotion::dynamic;
  const std::string other = [&]() -> std::string {
    if (result.march.model != MarchModel::dynamic) return "model";
    if (values.text("geometry") == "held") return "geometry";
    if (values.yes("friction.in_motion")) return "friction.in_motion";
    return values.asked_for("periodic.multipliers") ? "periodic.multipliers" : "";
  }();
  if (other.empty()) return PairMotion::quasi_static;
  values.refuse("motion", "is quasi_static, but '" + other + "' is " + values.text(other) + "; use one of the two");
}

std::vector<std::pair<double, double>> read_share_table(const ParameterValues& values) {
  const std::string name = "load_sharing.file";
  if (!values.has(name)) {
    values.refuse("load_sharing.kind",
                  "is table, but 'load_sharing.file' is "
                  "missing; give the file of the table");
  }
  return read_points(values, name, "a point of the load sharing; give two numbers, position [m] and share");
}

LoadSharing read_load_sharing(const CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const std::string& kind = values.text("load_sharing.kind");
  if (kind == "step") return LoadSharing::step(*result.pair.line);
  if (kind == "trapezoid") {
    return LoadSharing::trapezoid(*result.pair.line, values.real("load_sharing.at_end"),
                                  values.real("load_sharing.at_inner_edge"));
  }
  return LoadSharing::table(*result.pair.line, read_share_table(values));
}

/// One contact from its entry, or from a chosen position, to its exit.
void set_single_contact(CaseInput& result) {
  const ParameterValues& values = result.parameters;
  if (result.march.geometry == MeshGeometry::held) {
    values.refuse("geometry", "is held, but the model " + values.text("model") +
                                  " follows a contact along the line of action; set it to moving");
  }
  result.march.geometry = MeshGeometry::single;
  const double jump_length = result.pair.line->travel_velocity(result.pair.pinion_speed) * result.scales.time *
                             values.real("load_sharing.jump_time");
  const auto sharing = [&] { return read_load_sharing(result).with_jumps_over(jump_length); };
  result.march.load = PrescribedLoad{in_file_of(values, sharing), values.integer("load_sharing.jump_refinement")};
  if (values.text("start.place") != "position") result.march.start_position = result.pair.line->entry();
}

// Films make friction, and inertia answers to it.
void check_friction_in_motion(const CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const std::string name = "friction.in_motion";
  if (!values.yes(name)) return;
  std::string lacking;
  if (!result.traction) lacking = "'friction.law' is none; give the law";
  if (result.march.model != MarchModel::dynamic) {
    lacking = "'model' is " + values.text("model") + "; set it to dynamic";
  }
  if (!result.pair.equivalent_mass) lacking = "the gears have no inertia; give it";
  if (!lacking.empty()) values.refuse(name, "is yes, but " + lacking);
}

/// A ramp of speed, over all mesh periods where nothing else is said.
SpeedCourse read_speed_course(const CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const std::string end = "ramp.to_rpm", length = "ramp.periods";
  if (!values.has(end)) {
    if (!values.has(length)) return {};
    values.refuse(length, "is given, but not " + in_quotes(end) + "; give the speed at the end of the ramp");
  }
  if (result.march.geometry != MeshGeometry::moving) {
    values.refuse(end, "is given, but the contacts do not go round: 'geometry' is " + values.text("geometry") +
                           ", 'model' is " + values.text("model") + "; use geometry moving and model dynamic or dry");
  }
  const double periods = values.real_if_given(length).value_or(values.real("mesh_periods"));
  return SpeedCourse::over_phase(values.real(end) / values.real("pinion.speed_rpm"), periods * mesh_period(result));
}

std::optional<ErrorTolerance> read_step_tolerance(const ParameterValues& values) {
  const std::string motion = "time.tolerance", films = "time.film_tolerance";
  if (values.has(motion)) return ErrorTolerance{values.real(motion), values.real_if_given(films).value_or(HUGE_VAL)};
  if (!values.has(films)) return {};
  values.refuse(films, "is given, but not " + in_quotes(motion) + "; give the tolerance on the motion too");
}

/// Whether the pair swings, and on which stiffness.
void set_motion(CaseInput& result) {
  result.pair.stiffness = pitch_stiffness(result.scales, *result.pair.line, result.pair.teeth);
  result.march.model = read_model(result.parameters.text("model"));
  result.march.motion = read_motion(result);
}

void set_march(CaseInput& result) {
  const ParameterValues& values = result.parameters;
  result.march.start_position = read_start_position(result);
  result.march.geometry = values.text("geometry") == "held" ? MeshGeometry::held : MeshGeometry::moving;
  if (result.march.model == MarchModel::simplified || result.march.model == MarchModel::quasistatic)
    set_single_contact(result);
  result.march.mesh_periods = values.real("mesh_periods");
  result.march.course = read_speed_course(result);
  result.run.restart = values.yes("restart");
  result.run.time_limit = values.real_if_given("time_limit");
  result.run.keep_checkpoint = values.yes("keep_checkpoint");
  result.march.start_motion = read_start_motion(values);
  check_friction_in_motion(result);
  set_time_steps(result);
  result.march.step_tolerance = read_step_tolerance(values);
  result.search.options = {.tolerance = values.real("periodic.tolerance"),
                           .film_tolerance = values.real("periodic.film_tolerance"),
                           .max_periods = values.integer("periodic.max_periods")};
  result.search.order = values.integer("periodic.order");
  result.search.max_pattern = values.integer("periodic.max_pattern");
  const std::string multipliers = values.text("periodic.multipliers");
  result.search.with_multipliers = multipliers != "no" && result.march.motion == PairMotion::dynamic;
  result.search.multipliers_on_own_grid = multipliers == "own_grid";
  result.sweep = read_sweep(values);
  result.continuation = read_continuation(values, result.search.order);
  result.march.dry_damping_ratio = values.real_if_given("dry.damping_ratio");
  result.modes.count = values.integer("eigen.modes");
  result.modes.of_orbit = values.yes("eigen.orbit");
  result.modes.orbit_periods = values.integer("eigen.periods");
  result.march.snapshot_interval = values.real_if_given("output.snapshot_interval");
  check_snapshot_interval(result);
  result.march.spectrum_periods = values.real_if_given("output.spectrum_periods");
  if (result.march.spectrum_periods && *result.march.spectrum_periods > result.march.mesh_periods) {
    values.refuse("output.spectrum_periods", "is " + format_value(*result.march.spectrum_periods) + ", more than the " +
                                                 format_value(result.march.mesh_periods) +
                                                 " mesh periods marched; give at most mesh_periods");
  }
}

CaseInput build_case(const ParameterValues& values, const WornFlanks& worn, const std::shared_ptr<FaceLaws>& laws) {
  CaseInput result;
  result.parameters = values;
  result.face_laws = laws;
  result.name = read_name(values);
  result.kind = values.text("case.kind") == "gear_pair" ? CaseKind::gear_pair : CaseKind::contact;
  const Lubricant oil = read_lubricant(values);
  ReferenceContact reference =
      result.kind == CaseKind::gear_pair ? set_gear_pair(result, oil, worn) : read_bare_contact(values);
  FlankTopography topography = in_file_of(
      values, [&] { return read_topography(values, result.pair.line, reference.solids, oil, reference.operation); });
  result.pair.topography = topography.flanks;
  result.pair.shortest_waves = {topography.shortest_along, topography.shortest_across};
  topography.roughness_ratio = worn.roughness_ratio;
  reference.solids.rough = read_rough_surfaces(values, topography, reference.solids.reduced_modulus);
  result.run.all_processes = values.text("solver.processes") == "all";
  in_file_of(values, [&] {
    result.scales = make_scales(reference.solids, oil, reference.operation);
    if (result.scales.solids.face) result.scales.face_law = laws->law(result.scales, result.pair.line);
    check_strain(result);
  });
  if (result.pair.train) require_tooth_force(result, "the drive train");
  result.traction = read_traction(values);
  result.thermal_oil = read_thermal_oil(values);
  result.roughness = read_roughness(values, topography);
  result.wear = read_wear(values);
  if (result.wear && result.kind == CaseKind::gear_pair) result.wearing = read_wearing(values, result.roughness);
  result.stress = read_stress(values);
  result.fatigue = read_fatigue(values, result.stress ? result.scales.length * result.stress->depths.back() : 0.0);
  result.rating = read_rating(result);
  if (result.kind == CaseKind::gear_pair) set_motion(result);
  set_film_numerics(result);
  result.steady.position = read_position(result, "steady.position");
  result.steady.load_ratio = values.real("steady.load_ratio");
  if (result.kind == CaseKind::gear_pair) {
    result.statics = {read_numbers(values, "static.load_ratios", 1e-3, 1e3, "ratio of loads"),
                      values.integer("static.positions")};
    set_march(result);
  }
  result.run.directory = values.text("output.dir");
  in_file_of(values, [&] { check_loads(result); });
  result.numerics.on_widening = widening_notice(result.scales, contacts_at_a_time(result), heated_points(result));
  return result;
}

}  // namespace

CaseInput make_case(const ParameterValues& values) { return build_case(values, {}, std::make_shared<FaceLaws>()); }

CaseInput make_case_like(const CaseInput& given, const ParameterValues& values, const WornFlanks& worn) {
  return build_case(values, worn, given.face_laws);
}

CaseInput read_case(MPI_Comm comm, const std::string& file) { return make_case(read_parameters(comm, file)); }

}  // namespace gearfilm

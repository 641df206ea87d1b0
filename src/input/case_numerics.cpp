#include "input/case_numerics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/line_contact.hpp"
#include "contact/moes.hpp"
#include "dynamics/mesh_march.hpp"
#include "dynamics/segment_stepper.hpp"
#include "gearfilm/error.hpp"
#include "grid/load_beyond_edges.hpp"
#include "input/case_face.hpp"
#include "mesh/natural_frequency.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

/// Of the pair on its dry contacts, of a pair that swings [1/t*].
double frequency_of_swings(const CaseInput& problem) {
  return natural_frequency(problem.pair.stiffness, problem.scales.inertia(*problem.pair.equivalent_mass));
}

/// In a mesh period; none of a pair without inertia.
double number_of_swings(const CaseInput& problem) {
  return swings(problem) ? mesh_period(problem) / natural_period(problem) : 0.0;
}

/// By how much steps in time and rows are finer where the pair swings often in a mesh period: errors of forces, of
/// third order in time, add up from swing to swing.
double finer_for_forces(const CaseInput& problem) {
  constexpr double few_swings = 10.0;
  return std::max(1.0, std::cbrt(number_of_swings(problem) / few_swings));
}

/// By how much lines are finer there, and, up to a limit, steps in time once more: swings send waves of film with steep
/// fronts through the contact.
double finer_for_waves(const CaseInput& problem) {
  constexpr double few_swings = 12.0, most = 1.5;
  return std::clamp(std::sqrt(number_of_swings(problem) / few_swings), 1.0, most);
}

/// V at which the pair swings with half the Hertz approach as amplitude.
double velocity_of_swings(const CaseInput& problem) {
  return swings(problem) ? std::numbers::pi * frequency_of_swings(problem) * problem.scales.approach : 0.0;
}

/// The largest V at which unloaded flanks approach each other on the way to the pitch point, over lengths of a.
double velocity_of_entering(const CaseInput& problem) {
  const LineOfAction& line = *problem.pair.line;
  const Scales& scales = problem.scales;
  const double length = scales.hertz.a;
  const int lengths = static_cast<int>(std::ceil(-line.entry() / length));
  double largest = 0.0, before = problem.pair.teeth.gap(0, line.entry());
  for (int n = 1; n <= lengths; ++n) {
    const double gap = problem.pair.teeth.gap(0, line.entry() + n * length);
    largest = std::max(largest, before - gap);
    before = gap;
  }
  return largest / scales.thickness * line.travel_velocity(problem.pair.pinion_speed) * scales.time / length;
}

/// As for the film alone, and for what oil beyond its edges would carry while the pair swings and contacts enter.
Domain domain_of_pair(const CaseInput& problem, const Scales& scales) {
  const Domain domain = domain_of(ExpectedFilm(scales));
  if (!problem.pair.gears) return domain;
  const LoadBeyondEdges load(scales, velocity_of_swings(problem), velocity_of_entering(problem));
  const Domain longer = carrying_behind(domain, load);
  if (!has_ellipse(scales.solids)) return longer;
  return carrying_beside(longer, load, 0.5 * problem.pair.gears->face_width / scales.hertz.b);
}

Domain read_domain(const CaseInput& problem, const Scales& scales) {
  const ParameterValues& values = problem.parameters;
  const bool paper = values.text("grid.domain") == "paper" && has_ellipse(scales.solids);
  Domain domain = paper ? paper_domain(moes_groups(scales.solids, scales.oil, scales.operation).M)
                        : domain_of_pair(problem, scales);
  domain.x_min = values.real_if_given("grid.x_min").value_or(domain.x_min);
  domain.x_max = values.real_if_given("grid.x_max").value_or(domain.x_max);
  domain.y_half = values.real_if_given("grid.y_half").value_or(domain.y_half);
  return domain;
}

/// For the contact of such scales, in units of its own half axes.
Steps steps_of_contact(FilmDiscretisation discretisation, const Scales& scales, double accuracy) {
  ExpectedFilm film(scales);
  if (!film.rough) film.film = std::max(film.film, thinnest_film / scales.thickness);
  return steps_for(discretisation, film, accuracy);
}

/// At the reference contact as accurate as asked for. Along X no longer than that there are films under the static
/// force at the ends of the path, where flanks may be much more curved. Along X and Y no longer than that forces follow
/// an ellipse which grows and shrinks, or oil that carries over a rise of pressure longer than that, and that what oil
/// takes from swings is right. Along X finer for waves of film.
Steps steps_on_path(const CaseInput& problem, double accuracy) {
  constexpr double finest_rows = 4.0 / 3.0;
  constexpr double accuracy_at_ends = 0.3, longest_along = 0.1, longest_across = 0.12;
  const FilmDiscretisation discretisation = problem.numerics.discretisation;
  Steps steps = steps_of_contact(discretisation, problem.scales, accuracy);
  if (!problem.pair.line) return steps;
  steps.y = std::min(steps.y, longest_across / std::min(finer_for_forces(problem), finest_rows));
  steps.x = std::min(steps.x, longest_along * pressure_length(ExpectedFilm(problem.scales)));
  const LineOfAction& line = *problem.pair.line;
  for (const double xi : {line.entry(), line.exit()}) {
    ContactSolids solids = problem.scales.solids;
    ContactOperation operation = problem.scales.operation;
    solids.radius_x = line.radius_x(xi);
    operation.entrainment_velocity = line.entrainment_velocity(xi, problem.pair.pinion_speed);
    const Scales scales = make_scales(solids, problem.scales.oil, operation);
    const double own = steps_of_contact(discretisation, scales, std::max(accuracy, accuracy_at_ends)).x;
    steps.x = std::min(steps.x, own * scales.hertz.a / problem.scales.hertz.a);
  }
  steps.x /= finer_for_waves(problem);
  return steps;
}

const Tuned<double> nodes_in_wave("grid_nodes_in_wave", 30.0,
                                  "nodes in the shortest wave of the flanks, and time steps in which it passes");

/// The longest steps by which waves of the flanks are resolved, along X and Y.
Steps steps_by_waves(const CaseInput& problem) {
  const auto [along, across] = problem.pair.shortest_waves;
  return {along / (nodes_in_wave * problem.scales.hertz.a), across / (nodes_in_wave * problem.scales.hertz.b)};
}

void require_resolved_waves(const CaseInput& problem) {
  const Steps longest = steps_by_waves(problem);
  const auto require = [&](const std::string& name, int nodes, double length, double step) {
    if (length <= step * (nodes - 1) * (1.0 + 1e-9)) return;
    const int needed = nodes_along(length, step);
    problem.parameters.refuse(
        problem.parameters.has(name) ? name : "roughness.model",
        worded("needs ", needed, " nodes where ", nodes, " are given or possible: ", nodes_in_wave,
               " in the shortest wave of the flanks; give longer waves, a longer roughness.cutoff, or more nodes"));
  };
  const Domain& domain = problem.numerics.domain;
  require("grid.nx", problem.numerics.nx, domain.x_max - domain.x_min, longest.x);
  const bool is_row = problem.scales.solids.line;
  if (!is_row && !problem.numerics.face_rows) require("grid.ny", problem.numerics.ny, 2.0 * domain.y_half, longest.y);
}

void set_nodes(CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const Domain& domain = result.numerics.domain;
  Steps steps = steps_on_path(result, values.real("grid.accuracy"));
  const Steps by_waves = steps_by_waves(result);
  steps = {std::min(steps.x, by_waves.x), std::min(steps.y, by_waves.y)};
  const auto nodes = [&](const std::string& name, int chosen) {
    return values.has(name) ? values.integer(name) : std::min(chosen, most_nodes);
  };
  result.numerics.nx = nodes("grid.nx", nodes_along(domain.x_max - domain.x_min, steps.x));
  result.numerics.ny = nodes("grid.ny", nodes_across(2.0 * domain.y_half, steps.y));
  if (result.scales.solids.line || result.numerics.face_rows) {
    result.numerics.ny = grid_shape(result.numerics, result.scales).ny();
  }
  require_resolved_waves(result);
}

// Under more force the ellipse comes nearer to the inlet, but needs no longer one: half of what is there at first
// stays. Sides that were asked for stay until the ellipse is there but for a tenth of its distance; chosen ones go
// before they matter.
MarginRule margin_rule(const CaseInput& result) {
  const Domain& domain = result.numerics.domain;
  const bool chosen = result.parameters.text("grid.domain") == "auto" && !result.parameters.has("grid.y_half");
  MarginRule rule{.inlet = 0.5 * (-domain.x_min - 1.0), .side = 1.0 + (chosen ? 0.4 : 0.1) * (domain.y_half - 1.0)};
  if (result.pair.gears) rule.face = 0.5 * result.pair.gears->face_width / result.scales.length;
  return rule;
}

NewtonOptions read_newton_options(const ParameterValues& values, const std::string& section, double tolerance,
                                  double krylov_tolerance) {
  return {.tolerance = tolerance,
          .max_iterations = values.integer(section + ".newton_max_iterations"),
          .krylov_tolerance = krylov_tolerance,
          .krylov_max_iterations = values.integer(section + ".krylov_max_iterations")};
}

/// What Newton's method leaves of a step's rows, oil that is there too much or not, goes with the film: relative errors
/// of films come to it over H. No tighter than that of stationary films.
double step_tolerance(const Scales& scales) {
  constexpr double of_the_film = 6e-5;
  return std::clamp(of_the_film * ExpectedFilm(scales).film, NewtonOptions().tolerance, StepOptions().newton.tolerance);
}

// Between rough surfaces a linear solve that leaves much has nodes dry that oil fills, and others full that are dry,
// and the next iteration only puts that right.
NewtonOptions read_step_newton_options(const ParameterValues& values, const Scales& scales) {
  NewtonOptions usual = scales.solids.rough ? rough_step_newton() : StepOptions().newton;
  if (scales.solids.face) usual.krylov_tolerance = std::min(usual.krylov_tolerance, krylov_tolerance_over_faces);
  NewtonOptions options = read_newton_options(
      values, "time", values.real_if_given("time.newton_tolerance").value_or(step_tolerance(scales)),
      values.real_if_given("time.krylov_tolerance").value_or(usual.krylov_tolerance));
  options.tightest_krylov_tolerance =
      values.real_if_given("time.tightest_krylov_tolerance").value_or(usual.tightest_krylov_tolerance);
  options.unsolved = StepOptions().newton.unsolved;
  options.limit_changes = true;
  return options;
}

MultigridOptions read_multigrid_options(const ParameterValues& values) {
  return {.levels = values.integer("solver.levels"),
          .smoothing_sweeps = values.integer("solver.smoothing_sweeps"),
          .coarse_sweeps = values.integer("solver.coarse_sweeps"),
          .precision =
              values.text("solver.precision") == "double" ? Precision::double_precision : Precision::single_precision};
}

/// The longest step in which no flank moves by more than a part of its shortest wave.
double time_step_by_waves(const CaseInput& problem) {
  const double shortest = problem.pair.shortest_waves[0];
  if (!(shortest < HUGE_VAL)) return HUGE_VAL;
  const LineOfAction& line = *problem.pair.line;
  double fastest = 0.0;
  for (const double xi : {line.entry(), line.exit()}) {
    const double mean = line.entrainment_velocity(xi, problem.pair.pinion_speed);
    const double sliding = line.sliding_velocity(xi, problem.pair.pinion_speed);
    fastest = std::max(fastest, mean + 0.5 * std::abs(sliding));
  }
  return shortest / (nodes_in_wave * fastest * largest_speed_ratio(problem.parameters) * problem.scales.time);
}

/// More where oil stiffens much under pressure: where force falls, full nodes then empty within few steps. More where
/// the pair swings often in a mesh period. And more where the case asks for more than usual accuracy, since errors of
/// forces fall with the square of the step.
double steps_in_swing_of(const CaseInput& problem) {
  constexpr double stiffening = 17.3;  // Moes' L from which on they grow
  constexpr double most = 1.875;       // by how much
  constexpr double most_for_waves = 1.6;
  if (problem.dry()) return steps_in_swing;
  const Scales& scales = problem.scales;
  const double L = moes_groups(scales.solids, scales.oil, scales.operation).L;
  const double by_accuracy =
      std::sqrt(usual_accuracy / std::min(problem.parameters.real("grid.accuracy"), usual_accuracy));
  const double by_oil = L * L / (stiffening * stiffening);
  const double by_forces = finer_for_forces(problem);
  const double by_waves = std::min(by_forces * finer_for_waves(problem), most_for_waves);
  const double finer = std::min(std::max({by_oil, by_forces, by_waves}), most);
  return steps_in_swing * std::max(by_accuracy, finer);
}

// By the film, which oil passes with the velocity 1: a cell a step, but where the program chose the cells no less than
// 0.026, since what they resolve besides stands still before the contact. By the mesh, and by the swing of the gears.
// Films of pairs that swing have third order in time where that takes at most a third more steps.
double time_step(const CaseInput& result) {
  constexpr double most_for_third_order = 4.0 / 3.0;
  const double cell = steps_of(result.numerics).x;
  const double by_film = result.parameters.has("grid.nx") ? cell : std::max(cell, 0.026);
  const double faster = largest_speed_ratio(result.parameters);  // than at first, where scales are taken
  double step = std::min(by_film, mesh_period(result) / steps_in_mesh_period) / faster;
  if (!swings(result)) return step;
  step = std::min(step, natural_period(result) / steps_in_swing_of(result));
  const double damped = longest_damped_step * cell / faster;
  return step < most_for_third_order * damped ? std::min(step, damped) : step;
}

}  // namespace

std::string thin_film_remark(const CaseInput& problem) {
  const ParameterValues& values = problem.parameters;
  const double expected = problem.scales.thickness * ExpectedFilm(problem.scales).film;
  if (problem.scales.solids.rough || expected >= thinnest_film || (values.has("grid.nx") && values.has("grid.ny")))
    return "";
  return worded(std::setprecision(2), "the expected film is ", 1e9 * expected,
                " nm; between smooth surfaces no continuous film is thinner than ", 1e9 * thinnest_film,
                " nm: the grid is chosen for ", 1e9 * thinnest_film,
                " nm, and errors are larger than grid.accuracy; give grid.nx and grid.ny for another");
}

bool swings(const CaseInput& problem) {
  return problem.pair.equivalent_mass && problem.march.motion == PairMotion::dynamic;
}

double natural_period(const CaseInput& problem) {
  constexpr double felt_share = 1e-3;
  if (problem.pair.train && !problem.dry()) {
    const std::vector<TrainMode> modes = damped_train_of(problem).modes;
    double highest = 0.0;
    for (const TrainMode& mode : modes) {
      if (mode.mesh_share > felt_share) highest = std::max(highest, mode.frequency());
    }
    return 1.0 / (highest * problem.scales.time);
  }
  return 1.0 / frequency_of_swings(problem);
}

double largest_speed_ratio(const ParameterValues& values) {
  if (values.text("case.kind") != "gear_pair" || !values.has("ramp.to_rpm")) return 1.0;
  return std::max(1.0, values.real("ramp.to_rpm") / values.real("pinion.speed_rpm"));
}

double mesh_period(const CaseInput& problem) {
  return 1.0 / (mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed) * problem.scales.time);
}

void set_film_numerics(CaseInput& result) {
  const ParameterValues& values = result.parameters;
  // Thicker films begin further before the contact.
  ContactOperation fastest = result.scales.operation;
  fastest.entrainment_velocity *= largest_speed_ratio(values);
  result.numerics.domain = read_domain(result, make_scales(result.scales.solids, result.scales.oil, fastest));
  result.numerics.margins = margin_rule(result);
  result.numerics.discretisation =
      values.text("film.discretisation") == "central" ? FilmDiscretisation::central : FilmDiscretisation::fitted;
  if (result.scales.solids.face) {
    const double by_waves = steps_by_waves(result).y * result.scales.hertz.b;
    result.numerics.face_rows = read_row_grading(values, result.scales, result.numerics.discretisation, by_waves);
  }
  set_nodes(result);
  result.numerics.solver = {read_newton_options(values, "solver", values.real("solver.newton_tolerance"),
                                                values.real("solver.krylov_tolerance")),
                            read_multigrid_options(values)};
}

void set_time_steps(CaseInput& result) {
  const ParameterValues& values = result.parameters;
  const double by_waves = time_step_by_waves(result);
  if (values.has("time.dt") && values.real("time.dt") > by_waves)
    values.refuse("time.dt", "is " + format_value(values.real("time.dt")) +
                                 ", in which the shortest wave of the flanks is not resolved; give at most " +
                                 format_value(by_waves));
  result.numerics.steps = {.dT = values.has("time.dt") ? values.real("time.dt") : std::min(time_step(result), by_waves),
                           .newton = read_step_newton_options(values, result.scales)};
  result.numerics.step_levels = values.integer("time.levels");
  if (result.march.motion != PairMotion::quasi_static) return;
  const double period = mesh_period(result) / largest_speed_ratio(values);
  result.numerics.steps.of_transfer = part_of_transfer * period / steps_of_transfer;
  if (!values.has("time.dt")) result.numerics.steps.without_event = std::min(period / steps_in_mesh_period, by_waves);
}

CaseInput with_chosen_motion(const CaseInput& given, double many_swings, std::string& remark) {
  ParameterValues values = given.parameters;
  const bool choosable = !given.pair.train && !values.given("motion") && !values.asked_for("periodic.multipliers") &&
                         !values.given("periodic.order") && !values.yes("friction.in_motion") &&
                         given.march.model == MarchModel::dynamic && given.march.geometry == MeshGeometry::moving &&
                         !given.march.start_motion && swings(given);
  const double in_mesh_period = choosable ? mesh_period(given) / natural_period(given) : 0.0;
  if (in_mesh_period < many_swings) return given;
  remark = worded(std::setprecision(3), "the pair would swing ", in_mesh_period,
                  " times in a mesh period: bodies are taken to be in balance at every moment (motion: quasi_static); "
                  "-motion dynamic follows their swings");
  values.set("motion", "quasi_static", "the choice of motion by the program");
  CaseInput chosen = make_case_like(given, values);
  chosen.numerics.on_widening = given.numerics.on_widening;
  return chosen;
}

}  // namespace gearfilm

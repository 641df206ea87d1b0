#include "input/case_setup.hpp"

#include <cmath>
#include <iomanip>

#include "elasticity/row_contact.hpp"
#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "input/memory.hpp"

namespace gearfilm {

GridShape case_grid(const CaseInput& problem) { return grid_shape(problem.numerics, problem.scales); }

SharedDiscretisation discretise(MPI_Comm comm, const CaseInput& problem) {
  return discretise(comm, problem.numerics, problem.scales);
}

SharedDiscretisation discretise(const Grid& grid, const CaseInput& problem) {
  return discretise(grid, problem.numerics, problem.scales);
}

void require_tooth_force(const CaseInput& problem, const std::string& what) {
  const std::string name = "gear.load_model";
  if (!problem.pair.line || problem.parameters.text(name) == "point") return;
  throw InputError(std::setprecision(4), problem.parameters.origin(name), ": '", name,
                   "' is line_equivalent, with which the contact carries ", problem.scales.operation.load,
                   " N instead of the tooth's ", problem.pair.tooth_force, " N, but ", what,
                   " needs the whole force; set it to point");
}

void require_inertia(const CaseInput& problem) {
  const bool quasi_static =
      problem.march.model == MarchModel::quasistatic || problem.march.motion == PairMotion::quasi_static;
  if (problem.march.model != MarchModel::quasistatic) require_tooth_force(problem, "the motion of the pair");
  if (problem.pair.line && (problem.pair.equivalent_mass || quasi_static)) return;
  throw InputError("the case '" + problem.name +
                   "' has no inertia to march in time; give gear.equivalent_mass, or pinion.inertia and "
                   "wheel.inertia, of a gear pair, or motion: quasi_static");
}

void require_moving_contacts(const CaseInput& problem, const std::string& command, bool dry_too) {
  const auto refuse = [&](const std::string& name, const std::string& needed) {
    problem.parameters.refuse(name, "is " + problem.parameters.text(name) + ", but " + command +
                                        " is for all contacts of the pair, which travel; set it to " + needed);
  };
  const bool all = problem.march.model == MarchModel::dynamic || (dry_too && problem.dry());
  if (!all) refuse("model", dry_too ? "dynamic or dry" : "dynamic");
  if (problem.march.geometry == MeshGeometry::held) refuse("geometry", "moving");
  // Bodies in balance do not feel their mass, and a sweep of marches follows their swing.
  const bool states_alone =
      problem.sweep.kind == SweepKind::periodic && problem.sweep.parameter != "gear.equivalent_mass";
  const bool in_balance_too = command == "periodic" || (command == "sweep" && states_alone);
  if (problem.march.motion == PairMotion::quasi_static && !in_balance_too) {
    problem.parameters.refuse("motion", "is quasi_static, but " + command +
                                            (command == "sweep" ? " of marches or masses" : "") +
                                            " is for pairs that swing; set it to dynamic");
  }
}

void require_standing_heights(const CaseInput& problem, const std::string& command) {
  if (!(problem.pair.shortest_waves[0] < HUGE_VAL)) return;
  problem.parameters.refuse("roughness.model", "is " + problem.parameters.text("roughness.model") + ", but " + command +
                                                   " is at rest and heights travel with their flank; use transient "
                                                   "or periodic, or roughness.model stochastic");
}

namespace {

void require_repeating_torques(const CaseInput& problem, const std::string& command) {
  const TorquePattern& torques = problem.pair.train->pattern;
  const double mesh = mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed);
  const std::string mesh_words = worded(std::setprecision(10), "the mesh, ", mesh, " Hz");
  const std::string fixed = torques.fixed ? worded(std::setprecision(10), "has ", *torques.fixed, " Hz") : "";
  if (torques.fixed && command != "periodic") {
    throw InputError(torques.given_by + fixed + ", which is no order of a shaft, and " + command +
                     " changes how it repeats with the mesh; give an order");
  }
  if (!torques.periods) {
    throw InputError(torques.given_by + fixed + ", which never repeats together with " + mesh_words + ", while " +
                     command + " looks for states that do; give an order, or march (transient)");
  }
  const long pattern = whole_pattern(problem), most = problem.search.max_pattern;
  if (pattern <= most || problem.pair.teeth.pattern() == pattern) return;
  throw InputError(torques.given_by + (torques.fixed ? fixed + "; this " : "") + "and " + mesh_words +
                   ", repeat together after " + std::to_string(pattern) + " mesh periods, and " + command +
                   " looks for states that repeat after at most periodic.max_pattern = " + std::to_string(most) +
                   "; raise that to " + std::to_string(pattern) + (torques.fixed ? ", give an order" : "") +
                   ", or march that long (transient)");
}

}  // namespace

void require_one_pattern(const CaseInput& problem, const std::string& command) {
  const long pattern = whole_pattern(problem);
  if (problem.pair.train) require_repeating_torques(problem, command);
  if (pattern <= problem.search.max_pattern) return;
  std::string name;
  for (const char* key :
       {"wheel.pitch_errors_file", "wheel.pitch_errors", "pinion.pitch_errors_file", "pinion.pitch_errors"}) {
    if (problem.parameters.has(key)) name = key;
  }
  throw InputError(problem.parameters.origin(name), ": with '", name, "' the same teeth meet again after ", pattern,
                   " mesh periods, and ", command,
                   " looks for states that repeat after at most periodic.max_pattern = ", problem.search.max_pattern,
                   "; raise that, delete '", name, "', or march that long (transient)");
}

CaseInput periodic_case(const CaseInput& given, std::string& remark) {
  constexpr double many_swings = 40.0;  // of the pair in a mesh period
  require_inertia(given);
  require_moving_train(given, "periodic");
  CaseInput chosen = with_chosen_motion(given, many_swings, remark);
  require_moving_contacts(chosen, "periodic", true);
  require_one_pattern(chosen, "periodic");
  return chosen;
}

CaseInput transient_case(const CaseInput& given, std::string& remark) {
  constexpr double many_swings = 400.0;  // of the pair in a mesh period, each of some 40 time steps
  require_inertia(given);
  require_moving_train(given, "transient");
  const bool of_swings = given.march.course.duration > 0.0 || given.march.spectrum_periods;
  return of_swings ? given : with_chosen_motion(given, many_swings, remark);
}

GearInertias inertias_of(const CaseInput& problem) {
  const LineOfAction& line = *problem.pair.line;
  return problem.pair.inertias.value_or(
      disc_inertias({line.base_radius_pinion(), line.base_radius_wheel()}, *problem.pair.equivalent_mass));
}

namespace {

std::optional<InertiaShares> friction_couples_dynamics(const CaseInput& problem) {
  if (!problem.parameters.yes("friction.in_motion")) return {};
  const LineOfAction& line = *problem.pair.line;
  const auto [pinion, wheel] = inertias_of(problem);
  const double m_ge = *problem.pair.equivalent_mass;
  return InertiaShares{m_ge * line.base_radius_pinion() * line.base_radius_pinion() / pinion,
                       m_ge * line.base_radius_wheel() * line.base_radius_wheel() / wheel};
}

/// With the rows across the face, or across the Hertz ellipse.
std::optional<StressModel> stress_of_march(const CaseInput& problem) {
  constexpr double fineness = 1.0 / 16.0;  // of the width
  std::optional<StressModel> stress = problem.stress;
  if (!stress) return stress;
  const Scales& scales = problem.scales;
  const Face* face = scales.solids.face.get();
  stress->row_distance = fineness * (face ? face->width / scales.length : 2.0 / scales.hertz.ellipticity);
  if (face) stress->most_loaded = most_loaded_place(scales, scales.static_force, 1.0);
  return stress;
}

}  // namespace

MeshModel mesh_model(const CaseInput& problem, double start, MeshGeometry geometry, const SpeedCourse& course) {
  const bool inert = problem.march.model != MarchModel::quasistatic && problem.march.motion == PairMotion::dynamic &&
                     problem.pair.equivalent_mass;
  return {.scales = problem.scales,
          .path = ContactPath(*problem.pair.line, problem.scales, problem.pair.pinion_speed, start, geometry, course),
          .inertia = inert ? problem.scales.inertia(*problem.pair.equivalent_mass) : 0.0,
          .load = problem.march.load,
          .teeth = problem.pair.teeth,
          .topography = problem.pair.topography,
          .stiffness = problem.pair.stiffness,
          .tooth_force = problem.pair.tooth_force,
          .traction = problem.traction,
          .roughness = problem.roughness,
          .wear = problem.wear,
          .stress = stress_of_march(problem),
          .fatigue = problem.fatigue,
          .rating = problem.rating,
          .friction_couples_dynamics = friction_couples_dynamics(problem),
          .pattern = static_cast<int>(whole_pattern(problem)),
          .order = problem.search.order,
          .train = inert ? mesh_train_of(problem) : nullptr};
}

MeshModel mesh_after_leaving(const CaseInput& problem) {
  return mesh_model(problem, problem.pair.line->exit() - problem.pair.line->base_pitch());
}

int contacts_at_a_time(const CaseInput& problem) {
  const bool all = problem.pair.line && problem.march.geometry != MeshGeometry::single;
  return all ? static_cast<int>(std::ceil(problem.pair.line->contact_ratio())) : 1;
}

int heated_points(const CaseInput& problem) {
  return problem.traction && problem.traction->heats_film() ? problem.traction->heat->points : 0;
}

WideningObserver widening_check(int contacts, int points) {
  return [contacts, points](MPI_Comm comm, const GridShape& shape) {
    try {
      require_memory(comm, shape.nx, shape.ny(), contacts, points);
    } catch (const InputError& error) {
      throw SolveError(std::string("the grid cannot be widened: ") + error.what());
    }
  };
}

WideningObserver widening_notice(const Scales& scales, int contacts, int points) {
  return [scales, check = widening_check(contacts, points)](MPI_Comm comm, const GridShape& shape) {
    check(comm, shape);
    petsc_check(PetscPrintf(comm, "the grid is widened to %.3f < X < %.3f a, |y| < %.3f b: %d x %d nodes\n",
                            shape.x_min, shape.x_max, scales.hertz.ellipticity * shape.row_axis.half_width(), shape.nx,
                            shape.ny()));
  };
}

MeshMarch make_march(const CaseInput& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                     StepObserver observer, RunStore* store) {
  return make_march(mesh, problem.numerics, films, std::move(observer), store);
}

PairMarch make_pair_march(const CaseInput& problem, const MeshModel& mesh, const SharedDiscretisation& films,
                          StepObserver observer, RunStore* store) {
  if (!films) {
    const double damping_ratio = problem.march.dry_damping_ratio.value_or(0.0);
    return {mesh, problem.numerics.steps.dT, damping_ratio, std::move(observer), store};
  }
  PairNumerics numerics = problem.numerics;
  numerics.steps.tolerance = problem.march.step_tolerance;
  return {mesh, numerics, films, std::move(observer), store};
}

OrbitProblem orbit_problem(const CaseInput& problem) {
  return {.mesh = mesh_after_leaving(problem),
          .numerics = problem.numerics,
          .search = {.options = problem.search.options,
                     .with_multipliers = problem.search.with_multipliers,
                     .multipliers_on_own_grid = problem.search.multipliers_on_own_grid,
                     .start = problem.march.start_motion,
                     .dry_damping_ratio = problem.march.dry_damping_ratio.value_or(typical_film_damping)}};
}

}  // namespace gearfilm

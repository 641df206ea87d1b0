// The records. Units are SI; an angle or a speed in another unit says so in its name. Ends of ranges catch a wrong unit
// (millimetres for metres, GPa for Pa) and numbers that are none of a machine (1e-300 N m); the physics needs none.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "film/expected_errors.hpp"
#include "film/solver_options.hpp"
#include "grid/domain.hpp"
#include "input/continuation_options.hpp"
#include "input/parameter_records.hpp"
#include "orbits/dry_orbit.hpp"
#include "orbits/film_modes.hpp"
#include "orbits/periodic_orbit.hpp"

namespace gearfilm {
namespace {

Records case_records() {
  return section("case", Scope::any,
                 {optional("name of the case file", word("name", "name of the case in its results")),
                  choice("kind", {"gear_pair", "contact", "line"},
                         "a pair of spur gears, one bare contact given by its radii and load, or a line contact, "
                         "endless across, given by its radius and line load")});
}

const std::string face_width_meaning = "width of the face, which the gap along it and the ends belong to";

Records contact_records() {
  const std::string unless_reduced = "needed without contact.reduced_modulus";
  const Range modulus = left_open(1e5, 1e13);
  const Range ratio = right_open(0, 0.5);
  Records records = {
      number("radius_x", "R_x", "m", closed(1e-6, 1000), "reduced radius along the entrainment"),
      optional(
          "from the moduli and ratios of both bodies",
          number("reduced_modulus", "E'", "Pa", modulus, "reduced modulus, 2/E' = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2")),
      optional(unless_reduced, number("youngs_modulus_1", "E_1", "Pa", modulus, "Young's modulus, body 1")),
      optional(unless_reduced, number("poisson_ratio_1", "nu_1", "-", ratio, "Poisson's ratio, body 1")),
      optional(unless_reduced, number("youngs_modulus_2", "E_2", "Pa", modulus, "Young's modulus, body 2")),
      optional(unless_reduced, number("poisson_ratio_2", "nu_2", "-", ratio, "Poisson's ratio, body 2")),
      number("entrainment_velocity", "u_m", "m/s", closed(1e-6, 1e4), "mean velocity of the two surfaces"),
      preset(0.0, number("sliding_velocity", "u_1 - u_2", "m/s", closed(-2e4, 2e4),
                         "velocity of body 1 less that of body 2"))};
  for (const std::string body : {"1", "2"})
    records =
        joined(std::move(records), heated_body_records(body, "_" + body), roughness_of_body_records(body, "_" + body));
  records = joined(std::move(records), lay_records());
  const Records finite = joined(
      Records{
          number("load", "w", "N", closed(1e-9, 1e9), "load"),
          optional("none: no crowning, with contact.face_width",
                   former("crowning_radius",
                          number("radius_y", "R_y", "m", closed(1e-6, 1000), "reduced radius across the entrainment"))),
          optional("the contact has no ends", number("face_width", "F", "m", closed(1e-6, 10), face_width_meaning))},
      end_relief_records("of the gap"),
      Records{preset(0.0, number("misalignment", "", "m", closed(-1e-2, 1e-2),
                                 "by how much the gap opens over the face, towards +y")),
              preset(0.0, number("logarithmic_profile", "c_L", "m", closed(0.0, 1e-3),
                                 "factor of a logarithmic profile, -c_L ln(1 - (2 y/F)^2)"))},
      end_face_records());
  return joined(
      section("contact", Scope::bare, std::move(records)), section("contact", Scope::contact, finite),
      section("contact", Scope::line, {number("line_load", "w'", "N/m", closed(1e-9, 1e9), "load by unit length")}));
}

Records grid_records() {
  const auto in_words = [](const Domain& domain) {
    return format_value(domain.x_min) + " < X < " + format_value(domain.x_max) + ", half width " +
           format_value(domain.y_half);
  };
  const std::string by_domain = "by grid.domain";
  return section(
      "grid", Scope::any,
      {choice("domain", {"auto", "paper"},
              "where the edges are at first: auto, the inlet so far before the contact that it is flooded, sides and "
              "outlet clear of its ellipse, those of a pair where little would be carried beyond; paper, Table 1 of "
              "the paper (" +
                  in_words(paper_domain(0.0)) + " for M < 200, else " + in_words(paper_domain(HUGE_VAL)) +
                  "). They move outwards where a contact needs it"),
       preset(usual_accuracy,
              number("accuracy", "", "-", closed(1e-4, 0.2),
                     "relative error of the central and the smallest film that nx and ny are chosen for, where "
                     "they are not given; where they are, the error above which a warning says so. Below 0.02 "
                     "free oscillations get more steps")),
       optional("by grid.accuracy",
                whole("nx", "N_x", odd(17, 16385), "nodes along the entrainment, boundaries included")),
       optional("by grid.accuracy",
                whole("ny", "N_y", odd(9, 16385),
                      "nodes across the entrainment, boundaries included; the films being symmetric, those on "
                      "one side and in the middle are computed")),
       choice("whole_face", {"auto", "yes"},
              "rows over the whole face: where the contact under the static load reaches its ends, kinks or slope, or "
              "always; a contact that ends well within the face has a small domain about it"),
       optional("by the end of the face: 0.06, at free ends without relief 0.03",
                number("first_row", "", "a", closed(1e-3, 1.0), "distance of rows at the ends of a loaded face")),
       preset(1.35, number("row_growth", "", "-", closed(1.02, 3.0), "ratio of two distances of rows on it")),
       optional("by grid.accuracy: a tenth of half the contact's length, at least 2.5",
                number("largest_row", "", "a", closed(0.05, 20.0), "largest distance of rows on it")),
       optional(by_domain, number("x_min", "X_min", "a", right_open(-100, -1), "inlet edge of the domain")),
       optional(by_domain, number("x_max", "X_max", "a", left_open(1, 100), "outlet edge of the domain")),
       optional(by_domain, number("y_half", "", "b", left_open(1, 100), "half the width of the domain"))});
}

Records film_records() {
  return section("film", Scope::any,
                 {choice("discretisation", {"fitted", "central"},
                         "how the flow between two nodes is computed: fitted to oil whose viscosity changes by factors "
                         "from one node to the next, or central, as in the paper, which needs three to four times the "
                         "nodes along x and twice those along y")});
}

Records steady_records() {
  return section(
      "steady", Scope::any,
      {preset(0.0, number("position", "xi", "m", {}, "position on the path of contact, zero at the pitch point")),
       preset(1.0,
              number("load_ratio", "F/F*", "-", closed(1e-6, 1e6), "force on the contact over its reference load"))});
}

Records static_records() {
  return section("static", Scope::gear_pair,
                 {preset("0.25, 0.5, 0.75, 1, 1.25", word("load_ratios", "loads over the static force, a list")),
                  preset(400, whole("positions", "", closed(40, 100000), "positions of the gears in a mesh period"))});
}

Records march_records() {
  return section(
      "", Scope::gear_pair,
      {choice("model", {"dynamic", "simplified", "quasistatic", "dry"},
              "what is marched in time: the films of all contacts and the motion; one contact along the whole line of "
              "action whose share of the static force is prescribed, with inertia or without; the motion on dry Hertz "
              "contacts"),
       choice("motion", {"dynamic", "quasi_static"},
              "of the model dynamic, for `transient`, `periodic` and `sweep`: bodies have inertia, or are in balance "
              "with the "
              "forces of all contacts at every moment, which leaves out the swing after each entering contact; "
              "`periodic` chooses the latter where the pair would swing more than 40 times in a mesh period, "
              "`transient` more than 400 times, and no key needs the inertia"),
       choice("geometry", {"moving", "held"},
              "contacts that travel, enter and leave, or that are held at the start while their surfaces go on "
              "moving oil: a free oscillation"),
       preset(2.0, number("mesh_periods", "", "-", closed(1e-3, 1e6), "mesh periods to march"))});
}

Records ramp_records() {
  return section("ramp", Scope::gear_pair,
                 {optional("constant speed", number("to_rpm", "", "rpm", closed(1e-3, 1e6),
                                                    "transient: speed of the pinion that pinion.speed_rpm goes to, "
                                                    "evenly in time")),
                  optional("mesh_periods", number("periods", "", "-", closed(1e-3, 1e6),
                                                  "mesh periods from the start in which it does")),
                  flag("inertia_torque",
                       "the load gives way to what the inertias take, and teeth carry their part of it; "
                       "else the acceleration loads no tooth")});
}

Records run_records() {
  return section(
      "", Scope::gear_pair,
      {flag("restart", "go on where a run of the same case in the same folder stopped"),
       optional("none", number("time_limit", "", "s", left_open(0, 1e9),
                               "wall-clock time after which a march or search stops, to be continued")),
       flag("keep_checkpoint", "keep the checkpoint of a complete run, so that a march can go on beyond its end")});
}

Records load_sharing_records() {
  return section(
      "load_sharing", Scope::gear_pair,
      {choice(
           "kind", {"step", "trapezoid", "table"},
           "share of the static force in the models of one contact: 1/n where n contacts exist, ramps while there are "
           "two, or from load_sharing.file"),
       preset(1.0 / 3.0, number("at_end", "", "-", closed(1e-3, 10), "trapezoid: where a contact enters or leaves")),
       preset(2.0 / 3.0, number("at_inner_edge", "", "-", closed(1e-3, 10), "trapezoid: where it becomes alone")),
       optional("none", word("file",
                             "table: position [m] and share, one point a line; # begins a comment; a name in a case "
                             "file is relative to that file")),
       preset(0.025, number("jump_time", "", "-", closed(1e-6, 1),
                            "time that a jump of the share takes, in units of a/u_m as time.dt")),
       preset(10, whole("jump_refinement", "", closed(1, 10000), "least number of time steps in it"))});
}

Records start_records() {
  return section(
      "start", Scope::gear_pair,
      {choice("place", {"pitch", "after_leaving", "position"},
              "where the leading contact starts: at the pitch point, where it is when the one ahead of it has just "
              "left, or at start.position"),
       optional("0", number("position", "xi", "m", {}, "start on the line of action, with start.place position")),
       optional(
           "stationary films at rest that carry the static force",
           number("H0", "H_0", "-", closed(-1e3, 1e3),
                  "rigid displacement at the start; the films are stationary there. Of `periodic`: where the search "
                  "begins, just after a contact has left, instead of the dry pair's orbit")),
       optional("0", number("V0", "dH_0/dT", "-", closed(-1e3, 1e3), "velocity at the start, with start.H0"))});
}

std::string between_rough(double smooth, double rough) {
  return format_value(smooth) + ", between rough surfaces " + format_value(rough);
}

Records time_records() {
  const StepOptions standard;
  return section(
      "time", Scope::gear_pair,
      {optional("the shortest of the grid's h_x (at least 0.026 where grid.nx is not given), a hundredth of "
                "a mesh period, a fortieth to a 75th of a free oscillation",
                number("dt", "dT", "-", closed(1e-6, 1),
                       "time step in units of a/u_m; without inertia a hundredth of a mesh period where that is longer "
                       "and no event disturbs the films, unless it is given")),
       optional(
           "equal steps",
           number("tolerance", "", "-", closed(1e-12, 0.1),
                  "of `transient` on films: steps of up to 4 time.dt by their local errors, of H0, and of V0 times "
                  "half a free oscillation (at most times 1)")),
       optional("none", number("film_tolerance", "", "-", closed(1e-12, 0.1),
                               "the same on the root mean square of the pressures' errors, in units of p_h")),
       optional("6e-5 times the H that is expected at the pitch point, from 1e-8 to 1e-5",
                number("newton_tolerance", "", "-", right_open(1e-15, 1),
                       "bound on the root mean square of a step's scaled residual; films are left with relative errors "
                       "of about as much over H")),
       preset(standard.newton.max_iterations, whole("newton_max_iterations", "", at_least(1),
                                                    "Newton steps before a time step is tried again, and halved")),
       optional(
           between_rough(standard.newton.krylov_tolerance, rough_step_newton().krylov_tolerance) +
               ", over a whole face " + format_value(krylov_tolerance_over_faces),
           number(
               "krylov_tolerance", "", "-", right_open(1e-15, 1),
               "relative, of each linear solve in a time step, at most; no more than to half of Newton's tolerance")),
       optional(between_rough(standard.newton.tightest_krylov_tolerance, rough_step_newton().tightest_krylov_tolerance),
                number("tightest_krylov_tolerance", "", "-", right_open(1e-15, 1),
                       "the same at least, where that saves iterations of Newton's method")),
       preset(standard.newton.krylov_max_iterations,
              whole("krylov_max_iterations", "", at_least(1), "Krylov iterations per Newton step")),
       preset(0, whole("levels", "", closed(0, 20),
                       "multigrid levels of the preconditioner in time steps; 0: chosen by the grid"))});
}

Records periodic_records() {
  const PeriodicOptions standard;
  return section(
      "periodic", Scope::gear_pair,
      {preset(
           standard.tolerance,
           number(
               "tolerance", "", "-", right_open(1e-15, 1),
               "bound on the change over one period of H0, and of V0 times half a free oscillation (at most times 1)")),
       preset(standard.film_tolerance,
              number("film_tolerance", "", "-", right_open(1e-15, 1),
                     "bound on the largest change of any pressure, in units of p_h (of films that "
                     "feel their heat: on the root mean square of "
                     "each field over its largest value)")),
       preset(standard.max_periods,
              whole("max_periods", "", at_least(1), "mesh periods marched before the search ends")),
       preset(1, whole("order", "k", closed(1, 64),
                       "mesh periods, or patterns of teeth with errors, after which the state repeats")),
       preset(1,
              whole("max_pattern", "", closed(1, 10000),
                    "with pitch errors or a torque that fluctuates: most mesh periods after which the same teeth meet "
                    "again at the same torque")),
       choice(
           "multipliers", {"yes", "no", "own_grid"},
           "Floquet multipliers, by up to eight more periods: yes, on half the nodes, but where that leaves in doubt "
           "whether the state is stable; own_grid, on those of the case")});
}

Records eigen_records() {
  const FilmModeOptions modes;
  return section(
      "eigen", Scope::gear_pair,
      {preset(modes.count,
              whole("modes", "", closed(1, 1000), "eigenvalues of the pair on its films, nearest zero first")),
       choice("orbit", {"no", "yes"}, "multipliers of the periodic state too, with a bound for the films' own"),
       preset(5, whole("periods", "", closed(3, 100), "mesh periods spent on those multipliers"))});
}

Records sweep_records() {
  const std::string of_list = "from sweep.values";
  const auto start = [](const char* name, const char* meaning) {
    return optional("none", number(name, "", "-", {}, meaning));
  };
  return section(
      "sweep", Scope::gear_pair,
      {preset(std::string("speed"),
              word("over",
                   "what is varied: speed (pinion.speed_rpm) [rpm], torque (pinion.torque) [N m], equivalent_mass "
                   "(gear.equivalent_mass) [kg], or a number of the drive train by its key, as motor.inertia")),
       optional(of_list, number("from", "", "", {}, "smallest value, in the unit of what is varied")),
       optional(of_list, number("to", "", "", {}, "largest value")),
       preset(31, whole("points", "", closed(2, 100000),
                        "how many values from the smallest to the largest, equally spaced")),
       optional("from sweep.from to sweep.to", word("values", "list of the values instead, '8000, 9000, 12500'")),
       choice("direction", {"both", "up", "down"}, "in which order each point follows its neighbour"),
       preset(0, whole("chain_points", "", at_least(0),
                       "points that follow one another before a new start from the dry orbit; 0: all of a direction")),
       preset(0, whole("groups", "", at_least(0),
                       "groups of processes that work on different chains; 0: as many as there are chains")),
       choice("kind", {"periodic", "marches", "basins"},
              "periodic states; or marches, each from where the last one ended; or marches from a grid of starts"),
       preset(200, whole("march_periods", "", closed(2, 1000000), "mesh periods of each march")),
       preset(16,
              whole("kept_periods", "", closed(2, 1000000), "last mesh periods of each march, whose motions are kept")),
       start("H0_from", "smallest H_0 from which marches of basins start"), start("H0_to", "largest H_0"),
       start("V0_from", "smallest V_0, just after a contact has left"), start("V0_to", "largest V_0"),
       preset(21, whole("starts", "", closed(2, 10000), "number of starts of basins, in H_0 and in V_0 each"))});
}

Records continuation_records() {
  const ContinuationOptions dry = continuation_steps(false), films = continuation_steps(true);
  const auto step = [&](const char* name, double ContinuationOptions::*member, const char* meaning) {
    return optional(format_value(dry.*member) + " for the dry pair, " + format_value(films.*member) + " on films",
                    number(name, "", "-", closed(1e-9, 10), meaning));
  };
  return section(
      "continuation", Scope::gear_pair,
      {choice("parameter", {"speed", "torque", "mass", "viscosity"},
              "what is varied: pinion.speed_rpm [rpm], pinion.torque [N m], gear.equivalent_mass [kg] or "
              "lubricant.viscosity [Pa s]"),
       optional("none", number("from", "", "", {}, "where the branch begins, in the unit of what is varied")),
       optional("none", number("to", "", "", {}, "where it goes to, upwards or downwards; branches end at both ends")),
       step("first_step", &ContinuationOptions::first_step,
            "length of a branch's first step, in H_0, V_0 and tenths of the range"),
       step("smallest_step", &ContinuationOptions::smallest_step, "a branch that needs shorter steps is lost"),
       step("largest_step", &ContinuationOptions::largest_step, "longest step"),
       step("tolerance", &ContinuationOptions::located, "length of a step to which bifurcations are located"),
       preset(dry.most_points, whole("points", "", closed(2, 1000000), "largest number of points of a branch")),
       choice("follow_flips", {"yes", "no"}, "follow the branches of doubled period that begin at flips too"),
       preset(2, whole("largest_order", "", closed(1, 64), "largest order up to which they are followed"))});
}

Records dry_records() {
  return section(
      "dry", Scope::gear_pair,
      {optional("0 in a march and at rest, " + format_value(typical_film_damping) + " of periodic motions",
                number("damping_ratio", "zeta", "-", right_open(0, 1),
                       "damping ratio of a viscous damper beside dry contacts, instead of films; relative to f_n"))});
}

Records solver_records() {
  const SolverOptions standard;
  Parameter precision = choice("precision", {"single", "double"},
                               "arithmetic of the linearised film, its products and its preconditioner");
  if (standard.multigrid.precision == Precision::double_precision) precision.fallback = "double";
  return section(
      "solver", Scope::any,
      {choice("processes", {"useful", "all"},
              "processes that compute, of those started under mpiexec: as many as shorten the work, while the others "
              "sleep, or all"),
       preset(standard.newton.tolerance, number("newton_tolerance", "", "-", right_open(1e-15, 1),
                                                "bound on the root mean square of the scaled residual")),
       preset(standard.newton.max_iterations,
              whole("newton_max_iterations", "", at_least(1), "Newton steps per grid")),
       preset(
           standard.newton.krylov_tolerance,
           number("krylov_tolerance", "", "-", right_open(1e-15, 1),
                  "relative, of each linear solve; no more than to half of Newton's tolerance; between rough surfaces "
                  "down to 1e-3 where that saves iterations")),
       preset(standard.newton.krylov_max_iterations,
              whole("krylov_max_iterations", "", at_least(1), "Krylov iterations per Newton step")),
       preset(standard.multigrid.levels,
              whole("levels", "", closed(0, 20), "multigrid levels of the preconditioner; 0: chosen by the grid")),
       preset(standard.multigrid.smoothing_sweeps,
              whole("smoothing_sweeps", "", closed(1, 1000), "sweeps before and after a coarse-grid correction")),
       preset(standard.multigrid.coarse_sweeps,
              whole("coarse_sweeps", "", closed(1, 10000), "sweeps on the coarsest level")),
       std::move(precision)});
}

Records output_records() {
  return section(
      "output", Scope::any,
      {optional("output/ and case.name", word("dir", "directory that receives the results")),
       optional("none in a march, 0.05 in a periodic state",
                number("snapshot_interval", "", "-", at_least(0), "mesh periods between stored fields; 0: none")),
       optional("no spectrum", number("spectrum_periods", "", "-", closed(1e-3, 1e6),
                                      "mesh periods at the end of a march whose spectrum of H0 is computed"))});
}

}  // namespace

const std::vector<Parameter>& parameter_table() {
  static const Records table = joined(
      case_records(), gear_pair_records(), train_records(), contact_records(), roughness_records(), lubricant_records(),
      traction_records(), stress_records(), fatigue_records(), rating_records(), grid_records(), film_records(),
      steady_records(), static_records(), march_records(), ramp_records(), run_records(), load_sharing_records(),
      start_records(), time_records(), periodic_records(), eigen_records(), sweep_records(), continuation_records(),
      dry_records(), solver_records(), output_records());
  return table;
}

}  // namespace gearfilm

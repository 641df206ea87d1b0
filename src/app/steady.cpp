// `gearfilm steady`: the stationary film of one contact at one position on the line of action.
#include <iomanip>

#include "app/commands.hpp"
#include "app/derived.hpp"
#include "app/error_bar.hpp"
#include "app/friction_summary.hpp"
#include "app/result_warnings.hpp"
#include "app/screen_table.hpp"
#include "app/warning.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "input/case_numerics.hpp"
#include "output/film_snapshot.hpp"
#include "output/output_directory.hpp"
#include "output/progress.hpp"
#include "output/results_file.hpp"
#include "output/xdmf.hpp"
#include "traction/accurate_film.hpp"

namespace gearfilm {
namespace {

/// The contact at the chosen position: conditions for the solver, and in SI for the film formulas.
struct Position {
  MeshedContact contact;
  Compliance compliance;  ///< of its teeth
  ContactSolids solids;
  ContactOperation operation;
  std::string label = "bare contact";
};

Position steady_position(const Case& problem) {
  Position position;
  if (problem.pair.line) {
    const double xi = problem.steady.position;
    const MeshModel mesh = mesh_model(problem, xi, MeshGeometry::held);
    position.contact = mesh.contact_at(0, xi);
    if (!mesh.teeth.rigid())
      position.compliance =
          Compliance(Eigen::MatrixXd::Constant(1, 1, mesh.teeth.compliance(xi) * mesh.compliance_scale()));
    position.label = worded("contact 0 at xi = ", 1e3 * xi, " mm");
  }
  if (!problem.pair.line) {
    const double u_m = problem.scales.operation.entrainment_velocity;
    position.contact.conditions.sliding = problem.parameters.real("contact.sliding_velocity") / u_m;
  }
  position.solids = solids_of(problem.scales, position.contact.conditions);
  position.operation = problem.scales.operation;
  position.operation.entrainment_velocity *= position.contact.conditions.entrainment;
  position.operation.load *= problem.steady.load_ratio;
  return position;
}

/// Values with their error and what they tend to; null where the grid cannot tell.
void add_errors(const Scales& scales, const std::optional<GridErrors>& errors, Summary& summary) {
  const auto add = [&](const std::string& name, double unit, Estimate GridErrors::*figure) {
    add_error_bar(summary, name, errors ? std::optional((*errors).*figure) : std::nullopt, unit);
  };
  add("h_central", scales.thickness, &GridErrors::central_film);
  add("h_min", scales.thickness, &GridErrors::smallest_film);
  add("p_central", scales.pressure, &GridErrors::central_pressure);
  add("p_max", scales.pressure, &GridErrors::largest_pressure);
  add_error_bar(summary, "p_spike", errors ? errors->spike_pressure : std::nullopt, scales.pressure);
}

bool chosen_by_program(const Case& problem) {
  return !problem.parameters.has("grid.nx") && !problem.parameters.has("grid.ny");
}

/// Says where the films are less accurate than they should be.
void warn_of_errors(MPI_Comm comm, const Case& problem, const std::optional<GridErrors>& errors) {
  const bool chosen = chosen_by_program(problem);
  const double aim = chosen ? problem.parameters.real("grid.accuracy") : tolerable_error(problem);
  if (errors && errors->left() <= aim) return;
  warn(comm,
       errors ? worded(std::setprecision(2), "the films have an error of about ", 100.0 * errors->worst(), " %")
              : "the error of the films is not known, since a grid of half the nodes has no film",
       chosen ? "; lower grid.accuracy" : "; raise grid.nx and grid.ny, or leave them to the program");
}

Summary film_summary(const Case& problem, const Position& position, const Grid& grid, const StationaryResult& result,
                     const TractionFigures& friction) {
  const Scales& scales = problem.scales;
  Summary summary;
  summary["case"] = problem.name;
  summary["nx"] = grid.nx();
  summary["ny"] = grid.ny();
  if (problem.pair.line) summary["position"] = problem.steady.position;
  const ContactMoment at{scales, position.contact, result.figures, friction, problem.roughness};
  const Given given = given_figures(true, problem.traction, problem.roughness);
  for (const auto& figure : contact_figures) {
    if (!given.has(figure.needs)) continue;
    summary[std::string(figure.name)] = figure.unit.in_si(scales, figure.value(at));
  }
  summary["H0"] = result.solution.H0;
  summary["H_central"] = result.figures.central_film;
  summary["H_min"] = result.figures.smallest_film;
  summary["residual"] = result.counts.residual;
  SolveCounts total;
  for (const SolveCounts& counts : result.by_grid) {
    total.newton += counts.newton;
    total.krylov += counts.krylov;
    total.convolutions += counts.convolutions;
  }
  summary["newton_iterations"] = result.counts.newton;
  summary["krylov_iterations"] = result.counts.krylov;
  summary["convolutions"] = result.counts.convolutions;
  summary["newton_iterations_all_grids"] = total.newton;
  summary["krylov_iterations_all_grids"] = total.krylov;
  summary["convolutions_all_grids"] = total.convolutions;
  summary["predictions"] = film_predictions(position.solids, scales.oil, position.operation);
  const SurfaceVelocities velocities = velocities_of(scales, position.contact);
  summary["predictions"].update(
      friction_predictions(problem, position.solids, position.operation, velocities, friction.coefficient));
  summary["predictions"].update(
      heating_predictions(problem, position.solids, position.operation, velocities.sliding / velocities.mean));
  return summary;
}

void write_results(MPI_Comm comm, const Case& problem, const Position& position, const ContactFilm& film,
                   const TractionFields& friction, const Summary& summary) {
  const std::string group = "/contact0";
  ResultsFile file(comm, problem.run.directory / "results.h5");
  write_identity(file, problem, "steady");
  const Scales& scales = problem.scales;
  const WholeDomain domain(film.grid());
  file.grid(group, domain, scales);
  file.field(group, "P", "Pa", domain, film.total_pressure(), scales.pressure, group);
  file.field(group, "H", "m", domain, film.thickness(), scales.thickness, group);
  std::vector<std::string> datasets = {"P", "H"};
  for (const auto& [name, values] : traction_fields(film.grid(), friction)) {
    const ContactField kind = field_named(name);
    datasets.emplace_back(kind.dataset);
    file.field(group, datasets.back(), std::string(kind.unit.name), domain, values, 1.0, group);
  }
  if (problem.traction && problem.traction->heat) {
    file.rows(group, "temperature_across", "K", film.grid().nx(), problem.traction->heat->points, friction.across);
  }
  file.attribute(group, "xi", problem.steady.position);
  file.attribute(group, "R_x", position.solids.radius_x);
  file.attribute(group, "entrainment_velocity", position.operation.entrainment_velocity);
  file.attribute(group, "force", summary["force"].get<double>());
  file.attribute(group, "H0", summary["H0"].get<double>());
  file.attribute(group, "a", scales.hertz.a);
  file.attribute(group, "b", scales.hertz.b);
  file.attribute(group, "p_hertz", scales.hertz.pressure);
  file.finish();
  write_xdmf(comm, problem.run.directory / "results.xmf", "results.h5",
             {{0.0, {{0, group, group + "/mesh", film.grid().shape(), datasets}}}});
  write_summary(comm, problem.run.directory, summary);
}

void print_shear(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("shear_factor")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  petsc_check(PetscPrintf(comm,
                          "of a Newtonian oil %.4f um central, %.4f um smallest: factors of shear thinning %.3f and "
                          "%.3f; settled to %.1e in %d turns\n",
                          1e6 * real("h_central_newtonian"), 1e6 * real("h_min_newtonian"), real("shear_factor"),
                          real("shear_factor_min"), real("shear_change"), summary["shear_turns"].get<int>()));
}

void print_heating(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("thermal_factor")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  petsc_check(PetscPrintf(comm,
                          "without heat in the film %.4f um central, %.4f um smallest: thermal factors %.3f and %.3f, "
                          "Murch-Wilson's for rolling %.3f; settled to %.1e in %d turns\n",
                          1e6 * real("h_central_isothermal"), 1e6 * real("h_min_isothermal"), real("thermal_factor"),
                          real("thermal_factor_min"),
                          summary["predictions"]["murch_wilson_thermal_factor"].get<double>(), real("thermal_change"),
                          summary["thermal_turns"].get<int>()));
}

void print_friction(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("friction_coefficient")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  std::string heat;
  if (summary.contains("film_temperature_max")) {
    heat = worded(std::setprecision(4), "; largest temperature of the film ", real("film_temperature_max"),
                  " K, of the flanks ", real("surface_temperature_pinion"), " K and ",
                  real("surface_temperature_wheel"), " K");
  }
  say(comm, std::setprecision(4), "friction coefficient ", real("friction_coefficient"), "; lost by sliding ",
      real("power_sliding"), " W, by rolling ", real("power_rolling"), " W", heat);
}

void print_result(MPI_Comm comm, const std::filesystem::path& folder, const Position& position,
                  const Summary& summary) {
  const Summary& predicted = summary["predictions"];
  ScreenTable(summary)
      .text("stationary film of", worded(position.label, ", ", summary["nx"], " x ", summary["ny"], " nodes"))
      .add("central film", "h_central", 1e6, "um")
      .add("  towards finer grids", "h_central_extrapolated", 1e6, "um")
      .add(predicted, "  by Hamrock and Dowson", "hamrock_dowson_h_central", 1e6, "um")
      .add(predicted, "  by Nijenbanning and others", "nijenbanning_venner_moes_h_central", 1e6, "um")
      .add("smallest film", "h_min", 1e6, "um")
      .add("  towards finer grids", "h_min_extrapolated", 1e6, "um")
      .add(predicted, "  by Hamrock and Dowson", "hamrock_dowson_h_min", 1e6, "um")
      .add("largest pressure", "p_max", 1e-9, "GPa")
      .add("  in the centre", "p_central", 1e-9, "GPa")
      .add("  of the outlet's spike", "p_spike", 1e-9, "GPa")
      .add("force", "force", 1.0, "N")
      .text("work", worded(summary["newton_iterations"], " Newton and ", summary["krylov_iterations"],
                           " Krylov iterations on this grid, residual ", std::setprecision(3),
                           summary["residual"].get<double>()))
      .print(comm, folder);
}

/// What heat, or shear alone, has made of the film.
void add_coupling(const Case& problem, const SolvedContact& solved, Summary& summary) {
  if (!solved.coupled) return;
  const bool heated = problem.traction->heats_film();
  const std::string kind = heated ? "thermal" : "shear", bare = heated ? "isothermal" : "newtonian";
  const FilmFigures &with = solved.result.figures, &without = solved.bare;
  summary["h_central_" + bare] = problem.scales.thickness * without.central_film;
  summary["h_min_" + bare] = problem.scales.thickness * without.smallest_film;
  summary[kind + "_factor"] = with.central_film / without.central_film;
  summary[kind + "_factor_min"] = with.smallest_film / without.smallest_film;
  summary[kind + "_turns"] = solved.coupled->turns;
  summary[kind + "_newton_iterations"] = solved.coupled->newton;
  summary[kind + "_change"] = solved.coupled->change;
}

/// Says where film and heat or shear still change each other.
void warn_of_unrest(MPI_Comm comm, const SolvedContact& solved) {
  constexpr double tolerable = 1e-3;
  if (!solved.coupled || solved.coupled->change <= tolerable) return;
  warn(comm, std::setprecision(2),
       "the film and what heat and shear make of it did not quite settle: it goes on changing by ",
       100.0 * solved.coupled->change, " % a turn; raise grid.nx and grid.ny");
}

ContactProblem contact_problem(const Case& problem, const Position& position) {
  return {.scales = problem.scales,
          .conditions = position.contact.conditions,
          .load = LoadCondition::force(problem.steady.load_ratio * problem.scales.static_force, position.compliance),
          .discretisation = problem.numerics.discretisation,
          .solver = problem.numerics.solver,
          .traction = problem.traction,
          .label = position.label};
}

/// As accurate as asked for where the program chose the grid; says after a while what it is at.
SolvedContact solve_film(const Grid& grid, const Case& given, ContactProblem problem) {
  LongWork work(grid.comm());
  problem.solver.newton.watcher = [&](const std::string& text) { work.report(text); };
  if (!chosen_by_program(given) || !thin_film_remark(given).empty()) return solve_contact(grid, problem);
  return solve_contact_accurately(grid, problem, given.parameters.real("grid.accuracy"));
}

}  // namespace

void run_steady(MPI_Comm comm, const Case& problem) {
  const Position position = steady_position(problem);
  const double force = problem.steady.load_ratio * problem.scales.static_force;
  const DomainMargins needed =
      required_margins(problem.numerics.margins, problem.scales, position.contact.conditions, force, position.label);
  GridShape shape = case_grid(problem);
  if (!fits(shape, needed)) {
    shape = widened(shape, needed, problem.numerics.margins);
    announce_widening(comm, shape, problem.scales, 1, heated_points(problem));
  }
  const Grid grid(comm, shape);  // what is wrong with it is said before anything is removed
  const OutputDirectory directory(comm, problem.run.directory);
  directory.remove_earlier_results();
  const ContactProblem contact = contact_problem(problem, position);
  const SolvedContact solved = solve_film(grid, problem, contact);
  const Traction friction = traction_of(contact, solved);
  const double load_factor = problem.pair.line ? problem.pair.tooth_force / problem.scales.operation.load : 1.0;
  Summary summary = film_summary(problem, position, solved.film->grid(), solved.result,
                                 with_powers_times(load_factor, friction.figures));
  add_errors(problem.scales, solved.errors, summary);
  add_coupling(problem, solved, summary);
  write_results(comm, problem, position, *solved.film, friction.fields, summary);
  print_result(comm, directory.path(), position, summary);
  note_spike(comm, summary);
  print_shear(comm, summary);
  print_heating(comm, summary);
  print_friction(comm, summary);
  warn_of_errors(comm, problem, solved.errors);
  warn_of_heating(comm, problem, summary["predictions"]);
  warn_of_unrest(comm, solved);
  warn_of_validity(comm, summary);
}

}  // namespace gearfilm

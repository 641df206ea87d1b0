#include "results/steady_result.hpp"

#include "elasticity/tilted_contact.hpp"
#include "film/domain_margins.hpp"
#include "film/face_quantities.hpp"
#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "output/run_identity.hpp"
#include "output/snapshots.hpp"
#include "output/xdmf.hpp"
#include "results/derived.hpp"
#include "results/error_bar.hpp"
#include "results/friction_summary.hpp"
#include "results/members.hpp"
#include "results/rating_result.hpp"
#include "results/section_result.hpp"
#include "results/tilt_summary.hpp"

namespace gearfilm {
namespace {

/// Values with their error and what they tend to; null where the grid cannot tell.
void add_errors(const Scales& scales, const std::optional<GridErrors>& errors, Summary& summary) {
  const auto add = [&](const std::string& name, double unit, Estimate GridErrors::*quantity) {
    add_error_bar(summary, name, errors ? std::optional((*errors).*quantity) : std::nullopt, unit);
  };
  add("h_central", scales.thickness, &GridErrors::central_film);
  add("h_min", scales.thickness, &GridErrors::smallest_film);
  add("p_central", scales.pressure, &GridErrors::central_pressure);
  add("p_max", scales.pressure, &GridErrors::largest_pressure);
  add_error_bar(summary, "p_spike", errors ? errors->spike_pressure : std::nullopt, scales.pressure);
}

/// Of all grids on the way to the film.
SolveCounts total(const StationaryResult& result) {
  SolveCounts sum;
  for (const SolveCounts& counts : result.by_grid) {
    sum.newton += counts.newton;
    sum.krylov += counts.krylov;
    sum.convolutions += counts.convolutions;
  }
  return sum;
}

constexpr auto film_members = std::to_array<Member<StationaryResult>>({
    {"H0", "H_0", "-", "rigid displacement", [](const StationaryResult& of) -> Summary { return of.solution.H0; }},
    {"H_central", "H", "-", "central film in units of a^2/R_x",
     [](const StationaryResult& of) -> Summary { return of.quantities.central_film; }},
    {"H_min", "H", "-", "smallest film in units of a^2/R_x",
     [](const StationaryResult& of) -> Summary { return of.quantities.smallest_film; }},
    {"residual", "", "-", "last residual", [](const StationaryResult& of) -> Summary { return of.counts.residual; }},
    {"newton_iterations", "", "-", "iterations of Newton's method on the finest grid",
     [](const StationaryResult& of) -> Summary { return of.counts.newton; }},
    {"krylov_iterations", "", "-", "iterations of the linear solver there",
     [](const StationaryResult& of) -> Summary { return of.counts.krylov; }},
    {"convolutions", "", "-", "convolutions",
     [](const StationaryResult& of) -> Summary { return of.counts.convolutions; }},
    {"newton_iterations_all_grids", "", "-", "iterations of Newton's method, on all grids of the start",
     [](const StationaryResult& of) -> Summary { return total(of).newton; }},
    {"krylov_iterations_all_grids", "", "-", "iterations of the linear solver, on all grids of the start",
     [](const StationaryResult& of) -> Summary { return total(of).krylov; }},
    {"convolutions_all_grids", "", "-", "convolutions, on all grids of the start",
     [](const StationaryResult& of) -> Summary { return total(of).convolutions; }},
});

/// A film along a whole face.
struct AlongFace {
  const Scales& scales;
  const StationaryResult& result;
  double dry_radius = 1.0;  ///< of the contact, over R_x
  FaceQuantities face;

  /// [m^3/s]
  double flow(double side_flow) const {
    return scales.operation.entrainment_velocity * scales.thickness * scales.length * side_flow;
  }
};

constexpr auto face_members = std::to_array<Member<AlongFace>>({
    {"h_min_y", "y", "m", "place of the smallest film along the face",
     [](const AlongFace& of) -> Summary { return of.scales.length * of.face.smallest_film_at(); }},
    {"h_min_inner", "h", "m", "smallest film of rows that are farther than a from both ends",
     [](const AlongFace& of) -> Summary { return of.scales.thickness * of.face.smallest_film_beyond(1.0); }},
    {"h_corner", "h", "m",
     "film beneath the edges of the face, where no pressure is; a number of the grid where it is not positive",
     [](const AlongFace& of) -> Summary { return of.scales.thickness * of.face.corner_film(); }},
    {"p_max_y", "y", "m", "place of the largest pressure along the face",
     [](const AlongFace& of) -> Summary { return of.scales.length * of.face.largest_pressure_at(); }},
    {"tilting_moment", "M", "N m", "moment of the pressure about the middle of the face, int int p y dx dy",
     [](const AlongFace& of) -> Summary { return of.scales.force(of.face.tilting_moment) * of.scales.length; }},
    {"tilting_stiffness", "-dM/dtheta", "N m/rad",
     "by how much the moment falls with the misalignment, of the dry contact under the same force; null where that is "
     "not found",
     [](const AlongFace& of) -> Summary {
       try {
         return tilting_stiffness(of.scales, of.result.quantities.pressure_integral, of.dry_radius);
       } catch (const SolveError&) {
         return {};
       }
     }},
    {"approach", "", "m", "approach of the bodies, without what their ends give way as a whole",
     [](const AlongFace& of) -> Summary { return -of.scales.thickness * of.result.solution.H0; }},
    {"side_flow_lower", "", "m^3/s", "oil that leaves at the end of negative y beside the contact, x > -a",
     [](const AlongFace& of) -> Summary { return of.flow(of.face.side_flow_lower); }},
    {"side_flow_upper", "", "m^3/s", "the same at the end of positive y",
     [](const AlongFace& of) -> Summary { return of.flow(of.face.side_flow_upper); }},
});

/// A film that feels its heat or its shear, beside the one that does not.
struct Coupled {
  const Scales& scales;
  const SolvedContact& solved;

  /// Between rough surfaces, where H may be negative, of the mean gap.
  double factor(double FilmQuantities::*film) const {
    if (scales.solids.rough) {
      film = film == &FilmQuantities::central_film ? &FilmQuantities::central_mean_gap
                                                   : &FilmQuantities::smallest_mean_gap;
    }
    return solved.result.quantities.*film / solved.bare.*film;
  }
  double bare(double FilmQuantities::*film) const { return scales.thickness * solved.bare.*film; }
};

constexpr auto heat_members = std::to_array<Member<Coupled>>({
    {"h_central_isothermal", "", "m", "central film without heat",
     [](const Coupled& of) -> Summary { return of.bare(&FilmQuantities::central_film); }},
    {"h_min_isothermal", "", "m", "smallest film without heat",
     [](const Coupled& of) -> Summary { return of.bare(&FilmQuantities::smallest_film); }},
    {"thermal_factor", "", "-", "central film, of rough surfaces mean gap, with heat over that without",
     [](const Coupled& of) -> Summary { return of.factor(&FilmQuantities::central_film); }},
    {"thermal_factor_min", "", "-", "the same of the smallest",
     [](const Coupled& of) -> Summary { return of.factor(&FilmQuantities::smallest_film); }},
    {"thermal_turns", "", "-", "turns of film and heat",
     [](const Coupled& of) -> Summary { return of.solved.coupled->turns; }},
    {"thermal_newton_iterations", "", "-", "iterations of all films in them",
     [](const Coupled& of) -> Summary { return of.solved.coupled->newton; }},
    {"thermal_change", "", "-", "change of the film in the last turn",
     [](const Coupled& of) -> Summary { return of.solved.coupled->change; }},
});

constexpr auto shear_members = std::to_array<Member<Coupled>>({
    {"h_central_newtonian", "", "m", "central film of a Newtonian oil",
     [](const Coupled& of) -> Summary { return of.bare(&FilmQuantities::central_film); }},
    {"h_min_newtonian", "", "m", "smallest film of a Newtonian oil",
     [](const Coupled& of) -> Summary { return of.bare(&FilmQuantities::smallest_film); }},
    {"shear_factor", "", "-", "central film, of rough surfaces mean gap, over that of a Newtonian oil",
     [](const Coupled& of) -> Summary { return of.factor(&FilmQuantities::central_film); }},
    {"shear_factor_min", "", "-", "the same of the smallest",
     [](const Coupled& of) -> Summary { return of.factor(&FilmQuantities::smallest_film); }},
    {"shear_turns", "", "-", "turns of film and shear",
     [](const Coupled& of) -> Summary { return of.solved.coupled->turns; }},
    {"shear_newton_iterations", "", "-", "iterations of all films in them",
     [](const Coupled& of) -> Summary { return of.solved.coupled->newton; }},
    {"shear_change", "", "-", "relative change of the film in the last turns",
     [](const Coupled& of) -> Summary { return of.solved.coupled->change; }},
});

Summary film_summary(const CaseInput& problem, const SteadyPosition& position, const Grid& grid,
                     const StationaryResult& result, const TractionQuantities& friction, const ContactStress& stress) {
  const Scales& scales = problem.scales;
  Summary summary;
  summary["case"] = problem.name;
  summary["nx"] = grid.nx();
  summary["ny"] = grid.ny();
  if (problem.pair.line) summary["position"] = problem.steady.position;
  const double load_factor = problem.pair.line ? problem.pair.tooth_force / problem.scales.operation.load : 1.0;
  const QuantityInputs at{scales,      position.contact, result.quantities,   friction, problem.roughness, problem.wear,
                          load_factor, stress,           problem.rating.get()};
  const AvailableModels given = available_models(true, problem.traction, problem.roughness, scales.solids, problem.wear,
                                                 problem.stress, problem.rating.get());
  for (const auto& quantity : contact_quantities) {
    if (!given.has(quantity.needs)) continue;
    summary[std::string(quantity.name)] = quantity.unit.in_si(scales, quantity.value(at));
  }
  if (problem.rating) {
    summary["safety"] =
        safeties_at_rest(mesh_model(problem, problem.steady.position, MeshGeometry::held),
                         {.number = 0, .position = problem.steady.position, .quantities = quantities_of(at)});
  }
  add_members(film_members, result, summary);
  summary["predictions"] = film_predictions(position.solids, scales.oil, position.operation);
  const SurfaceVelocities velocities = velocities_of(scales, position.contact);
  summary["predictions"].update(
      friction_predictions(problem, position.solids, position.operation, velocities, friction.coefficient));
  summary["predictions"].update(
      heating_predictions(problem, position.solids, position.operation, velocities.sliding / velocities.mean));
  return summary;
}

/// What heat, or shear alone, has made of the film.
void add_coupling(const CaseInput& problem, const SolvedContact& solved, Summary& summary) {
  if (!solved.coupled) return;
  const Coupled coupled{problem.scales, solved};
  if (problem.traction->heats_film()) {
    add_members(heat_members, coupled, summary);
  } else {
    add_members(shear_members, coupled, summary);
  }
}

/// Row by row of the whole face.
void write_face(ResultsFile& file, const std::string& group, const Scales& scales, const FaceQuantities& face) {
  const auto write = [&](const char* name, const char* unit, double in_si, const std::vector<double>& values) {
    std::vector<double> scaled(values);
    for (double& value : scaled) value *= in_si;
    file.rows(group, name, unit, static_cast<int>(scaled.size()), 1, scaled);
  };
  write("line_load", "N/m", scales.pressure * scales.length, face.line_load);
  write("h_central_of_row", "m", scales.thickness, face.central_film);
  write("h_min_of_row", "m", scales.thickness, face.smallest_film);
  write("p_max_of_row", "Pa", scales.pressure, face.largest_pressure);
}

/// Stresses in the section below a row.
void write_section(ResultsFile& file, const std::string& group, const Scales& scales, const WholeSection& section) {
  const int lines = static_cast<int>(section.x.size()), depths = static_cast<int>(section.z.size());
  file.rows(group, "x", "m", lines, 1, section.x);
  file.rows(group, "z", "m", depths, 1, section.z);
  constexpr std::array<const char*, body_count> of_body = {"_pinion", "_wheel"};
  for (std::size_t body = 0; body < body_count; ++body) {
    write_stresses(file, group, of_body[body], depths, lines, section.stress[body]);
  }
  file.attribute(group, "a", scales.hertz.a);
}

ContactProblem contact_problem(const CaseInput& problem, const SteadyPosition& position) {
  return {.scales = problem.scales,
          .conditions = position.contact.conditions,
          .load = LoadCondition::force(problem.steady.load_ratio * problem.scales.static_force, position.compliance),
          .discretisation = problem.numerics.discretisation,
          .solver = problem.numerics.solver,
          .traction = problem.traction,
          .label = position.label};
}

}  // namespace

SteadyPosition steady_position(const CaseInput& problem) {
  SteadyPosition position;
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

GridShape steady_grid(MPI_Comm comm, const CaseInput& problem, const SteadyPosition& position,
                      const WideningObserver& on_widening) {
  const double force = problem.steady.load_ratio * problem.scales.static_force;
  const DomainMargins needed =
      required_margins(problem.numerics.margins, problem.scales, position.contact.conditions, force, position.label);
  GridShape shape = case_grid(problem);
  if (fits(shape, needed)) return shape;
  GridShape wide = widened(shape, needed, problem.numerics.margins);
  on_widening(comm, wide);
  return wide;
}

bool chooses_nodes(const CaseInput& problem) {
  return !problem.parameters.has("grid.nx") && !problem.parameters.has("grid.ny");
}

SteadyResult solve_steady(const Grid& grid, const CaseInput& problem, const SteadyPosition& position,
                          const Watcher& watcher) {
  ContactProblem contact = contact_problem(problem, position);
  contact.solver.newton.watcher = watcher;
  const bool by_accuracy = chooses_nodes(problem) && thin_film_remark(problem).empty();
  SteadyResult result{position,
                      by_accuracy ? solve_contact_accurately(grid, contact, problem.parameters.real("grid.accuracy"))
                                  : solve_contact(grid, contact),
                      {},
                      0,
                      {}};
  const double load_factor = problem.pair.line ? problem.pair.tooth_force / problem.scales.operation.load : 1.0;
  result.friction = traction_of(contact, result.solved);
  result.friction.quantities = with_powers_times(load_factor, result.friction.quantities);
  const SolvedContact& solved = result.solved;
  ContactStress stress{};
  if (problem.stress) {
    result.stress_row = most_loaded_row(*solved.film);
    stress = contact_stress(problem.scales, film_sections(*problem.stress, *solved.film,
                                                          result.friction.fields.shear_stress, {result.stress_row}));
  }
  result.summary =
      film_summary(problem, position, solved.film->grid(), solved.result, result.friction.quantities, stress);
  add_errors(problem.scales, solved.errors, result.summary);
  add_coupling(problem, solved, result.summary);
  add_tilt(problem, result.summary);
  if (problem.scales.solids.face) {
    add_members(face_members,
                AlongFace{problem.scales, solved.result, position.contact.conditions.dry_radius(),
                          face_quantities(*solved.film)},
                result.summary);
  }
  return result;
}

namespace {

/// `count` values that one process has and the others lack, on all of them. Collective.
std::vector<double> on_all(MPI_Comm comm, std::vector<double> values, int count) {
  values.resize(static_cast<std::size_t>(count), 0.0);
  MPI_Allreduce(MPI_IN_PLACE, values.data(), count, MPI_DOUBLE, MPI_SUM, comm);
  return values;
}

}  // namespace

void write_results(MPI_Comm comm, const CaseInput& problem, const SteadyResult& result) {
  const ContactFilm& film = *result.solved.film;
  const TractionFields& friction = result.friction.fields;
  const Summary& summary = result.summary;
  const SteadyPosition& position = result.position;
  const std::string group = "/contact0";
  ResultsFile file(comm, problem.run.directory / "results.h5");
  write_identity(file, problem, "steady");
  const Scales& scales = problem.scales;
  const WholeDomain domain(film.grid());
  file.grid(group, domain, scales);
  std::vector<NamedField> fields = film_fields(film, &friction);
  for (NamedField& field : stress_fields(problem.stress, film, &friction, {result.stress_row})) {
    fields.push_back(std::move(field));
  }
  const std::vector<std::string> datasets = write_fields(file, group, domain, scales, fields, group);
  if (problem.traction && problem.traction->heat) {
    // The process whose rows have the middle one of the face has them, the first or another.
    const int nx = film.grid().nx(), points = problem.traction->heat->points;
    file.rows(group, "temperature_across", "K", nx, points, on_all(comm, friction.across, nx * points));
  }
  if (problem.scales.solids.face) write_face(file, group, scales, face_quantities(film));
  if (problem.stress) {
    const FilmSections sections = film_sections(*problem.stress, film, friction.shear_stress, {result.stress_row});
    write_section(file, group + "/section", scales, whole_section(scales, sections));
    file.attribute(group + "/section", "y", scales.length * film.grid().row_axis().y(result.stress_row));
  }
  file.attribute(group, "xi", problem.steady.position);
  file.attribute(group, "R_x", position.solids.radius_x);
  file.attribute(group, "entrainment_velocity", position.operation.entrainment_velocity);
  file.attribute(group, "force", summary["force"].get<double>());
  file.attribute(group, "H0", summary["H0"].get<double>());
  file.attribute(group, "a", scales.hertz.a);
  if (!scales.solids.line) file.attribute(group, "b", scales.hertz.b);
  file.attribute(group, "p_hertz", scales.hertz.pressure);
  file.finish();
  write_xdmf(comm, problem.run.directory / "results.xmf", "results.h5",
             {{0.0, {{0, group, group + "/mesh", film.grid().shape(), datasets}}}});
  write_summary(comm, problem.run.directory, summary);
}

std::string steady_markdown() {
  return members_markdown(
             "The film of `steady`",
             "Keys of its summary, beside the quantities of the contact (columns of `/history/contacts`), the "
             "error bars of films and pressures (`NAME_error`, `NAME_extrapolated`), and the `predictions` of "
             "formulas.",
             film_members) +
         members_markdown("The film along a whole face", "Where a contact reaches the ends of the face.",
                          face_members) +
         members_markdown("The effect of heat on the film", "With `thermal.model: film`.", heat_members) +
         members_markdown("The effect of shear on the film",
                          "With `friction.in_film: yes` and without heat in the film.", shear_members);
}

}  // namespace gearfilm

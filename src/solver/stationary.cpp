#include "solver/stationary.hpp"

#include <cmath>
#include <memory>
#include <sstream>

#include "contact/film_formulas.hpp"
#include "contact/line_contact.hpp"
#include "film/face_pressure.hpp"
#include "film/transfer.hpp"
#include "gearfilm/error.hpp"
#include "grid/integral.hpp"
#include "numerics/tuned.hpp"
#include "parallel/events.hpp"
#include "solver/rough_start.hpp"

namespace gearfilm {
namespace {

const Tuned<double> first_pseudo_step("stationary_first_pseudo_step", 0.05, "first pseudo-time step");
const Tuned<double> last_pseudo_step("stationary_last_pseudo_step", 20.0,
                                     "pseudo-time step after which Newton's method goes on alone");
const Tuned<double> shortest_pseudo_step("stationary_shortest_pseudo_step", 1e-6, "shortest pseudo-time step");
const Tuned<double> pseudo_step_growth("stationary_pseudo_step_growth", 4.0,
                                       "growth of pseudo-time steps until one fails");
const Tuned<double> careful_growth(
    "stationary_careful_growth", 2.0,
    "growth of pseudo-time steps once one has failed, at most, and its root once another has");
const Tuned<int> easy_pseudo_step("stationary_easy_pseudo_step", 5,
                                  "Newton iterations of a pseudo-time step after which growth recovers, at most");
const Tuned<double> growth_recovery("stationary_growth_recovery", 1.5,
                                    "power of growth after an easy pseudo-time step");
const Tuned<double> rough_tolerance("stationary_rough_tolerance", 1e-5,
                                    "tolerance of films from which only others are computed");
const Tuned<int> coarsest_nx("stationary_coarsest_nx", 33, "lines of the grid on which sequencing starts, at least");

const Tuned<double> parting("stationary_parting", 0.1,
                            "by how much rough surfaces of a coarser grid are parted on a finer one, in sigma");

double rough(double tolerance) { return std::max<double>(tolerance, rough_tolerance); }

/// One step of pseudo-time from a solution to the next: as the last one, else with the other kind of changes. Free ones
/// swing between full and empty nodes at edges of slender contacts; limited ones never leave guesses that overlap.
bool step_to_next(StationaryNewton& newton, const LoadCondition& load, double shift, Changes& changes,
                  FilmSolution& solution) {
  const Changes other = changes == Changes::free ? Changes::limited : Changes::free;
  for (const Changes tried : {changes, other}) {
    newton.limit_changes(tried);
    newton.begin(load, solution);
    if (!newton.step(shift)) continue;
    changes = tried;
    solution = newton.films();
    return true;
  }
  return false;
}

/// Marches the squeeze term with a growing step until it no longer matters, then solves without it.
bool solve_through_pseudo_time(StationaryNewton& newton, const LoadCondition& load, FilmSolution& solution) {
  const double tolerance = newton.tolerance();
  newton.aim_at(rough(tolerance));
  double step = first_pseudo_step, growth = pseudo_step_growth, most_growth = growth;
  Changes changes = Changes::free;
  for (int attempt = 0; attempt < 60 && step < last_pseudo_step && step > shortest_pseudo_step; ++attempt) {
    const int before = newton.counts().newton;
    if (step_to_next(newton, load, 1.0 / step, changes, solution)) {
      const bool easy = newton.counts().newton - before <= easy_pseudo_step;
      if (easy) growth = std::min<double>(most_growth, std::pow(growth, growth_recovery));
      step *= growth;
    } else {
      step *= 0.25;
      most_growth = careful_growth;
      growth = std::min<double>(most_growth, std::sqrt(growth));
    }
  }
  newton.aim_at(tolerance);
  return step > shortest_pseudo_step && newton.solve(load, solution);
}

/// Solves from a guess by Newton alone, or through pseudo-time where that fails.
bool solve_from(StationaryNewton& newton, const LoadCondition& load, FilmSolution& guess) {
  newton.limit_changes(Changes::free);
  FilmSolution direct = guess;
  if (!newton.solve(load, direct)) return solve_through_pseudo_time(newton, load, guess);
  guess = std::move(direct);
  return true;
}

/// Solves from the dry contact: of rough surfaces from theirs, and as between smooth ones where that fails.
bool solve_from_dry(StationaryNewton& newton, ContactFilm& film, const LoadCondition& load, FilmSolution& guess) {
  if (film.scales().solids.rough) {
    FilmSolution mixed = guess;
    if (solve_from_dry_contact(newton, film, load, mixed)) {
      guess = std::move(mixed);
      return true;
    }
  }
  return solve_from(newton, load, guess);
}

/// Solves from the film on a coarser grid. Rough surfaces are parted a little, so that oil carries everywhere at first,
/// and there is a better way than pseudo-time where that fails: the dry contact.
bool solve_from_coarse(StationaryNewton& newton, const ContactFilm& film, const LoadCondition& load,
                       FilmSolution& guess) {
  if (!film.scales().solids.rough) return solve_from(newton, load, guess);
  if (load.kind == LoadCondition::Kind::force) {
    guess.H0 += parting * film.scales().solids.rough->sigma() / film.scales().thickness;
  }
  return newton.solve(load, guess);
}

/// Along a whole face or a line: dry pressure, with the dry contact's gap at the film that the formula expects.
FilmSolution dry_guess_of_rows(ContactFilm& film, const LoadCondition& load) {
  const Scales& scales = film.scales();
  FilmSolution guess{std::vector<double>(film.grid().local_size(), 0.0), load.value};
  const double expected = ExpectedFilm(scales).film, compliance = load.compliance(0, 0);
  const auto approach_under = [&](double force) {
    return face_pressure(*film.discretisation(), scales, film.conditions(), force, guess.pressure);
  };
  if (load.kind == LoadCondition::Kind::force) {
    approach_under(load.value);
    guess.H0 = expected - film.quantities(guess.pressure, 0.0).central_film - compliance * load.value;
    return guess;
  }
  if (!scales.face_law) return guess;
  const double wanted = expected - load.value - film.conditions().gap_offset;
  const ContactLaw law = contact_law(scales, film.conditions());
  double force = law.force(expected - load.value - film.conditions().dry_gap(), compliance);
  // The law is smooth, the rows are what they are: a correction leaves less than a film.
  for (int n = 0; n < 2 && force > 0.0; ++n) {
    const double lacking = wanted - approach_under(force) - compliance * force;
    force = std::clamp(force + lacking / (1.0 / law.stiffness(force) + compliance), 0.5 * force, 2.0 * force);
  }
  if (force > 0.0) approach_under(force);
  return guess;
}

/// Dry pressure, with the dry contact's flat gap at the film that the formula expects.
FilmSolution dry_guess(ContactFilm& film, const LoadCondition& load) {
  const Scales& scales = film.scales();
  if (!has_ellipse(scales.solids)) return dry_guess_of_rows(film, load);
  const ContactSolids solids = solids_of(scales, film.conditions());
  double gap = hamrock_dowson_central(scales.solids, scales.oil, scales.operation);
  if (scales.solids.rough) gap = std::max(gap, scales.thickness * ExpectedFilm(scales).film);
  FilmSolution guess{std::vector<double>(film.grid().local_size(), 0.0), load.value};
  double force = scales.force(load.value);
  if (load.kind == LoadCondition::Kind::displacement) {
    const double approach = gap / scales.thickness - load.value - film.conditions().dry_gap();
    const double unit_force = force_at_unit_approach(scales, film.conditions());
    force = scales.force(force_on_spring(unit_force, load.compliance(0, 0), approach));
    if (force <= 0.0) return guess;
  }
  const HertzContact dry = hertz_contact(solids, force);
  hertz_pressure(film.grid(), scales, dry, guess.pressure, film.conditions().nearest.X);
  if (load.kind == LoadCondition::Kind::force) {
    guess.H0 =
        (gap - dry.approach) / scales.thickness - film.conditions().dry_gap() - load.compliance(0, 0) * load.value;
  }
  return guess;
}

/// The film's surfaces on coarser and coarser grids.
std::vector<ContactSurfaces> surfaces_on(const std::vector<SharedDiscretisation>& coarser, const ContactFilm& film) {
  std::vector<ContactSurfaces> surfaces;
  const Grid* finer = &film.grid();
  for (const SharedDiscretisation& next : coarser) {
    surfaces.push_back(injected_surfaces(*finer, next->grid(), surfaces.empty() ? film.surfaces() : surfaces.back()));
    finer = &next->grid();
  }
  return surfaces;
}

FilmSolution interpolate(const Grid& coarse_grid, const Grid& fine_grid, const FilmSolution& coarse) {
  Field<double> values(coarse_grid), interpolated(fine_grid);
  values.load(coarse.pressure);
  interpolate_cubic(coarse_grid, fine_grid, values, interpolated);
  FilmSolution fine;
  fine.pressure.resize(fine_grid.local_size());
  interpolated.store(fine.pressure);
  for (double& pressure : fine.pressure) pressure = std::max(pressure, 0.0);
  fine.H0 = coarse.H0;
  return fine;
}

/// What flanks may do at the ends of their face, where no film is found; empty where they end elsewhere.
std::string word_of_ends(const ContactFilm& film, double worst_Y) {
  const Face* face = film.scales().solids.face.get();
  if (!face) return {};
  if (face->end == EndFace::half_space) {
    return "; flanks whose solids go on beyond the end of the face may touch there, with no film: give an end relief, "
           "or end_face: free";
  }
  const bool beside_end = std::abs(worst_Y) > film.grid().shape().row_axis.half_width() - 1.0;
  return beside_end ? "; at the corner of a sharp end the flanks may touch, with no film: give an end relief" : "";
}

[[noreturn]] void report_failure(const ContactFilm& film, const StationaryNewton& newton) {
  const Grid& grid = film.grid();
  const SolveCounts& counts = newton.counts();
  const WorstNode worst = newton.worst(0);
  std::ostringstream message;
  message << "stationary film not converged on the grid " << grid.nx() << " x " << grid.ny() << ": residual "
          << counts.residual << " after " << counts.newton << " Newton iterations, the largest " << describe(worst)
          << "; try a finer grid (grid_nx, grid_ny) or a wider domain (grid_x_min, grid_x_max, "
             "grid_y_half), or raise solver_newton_max_iterations"
          << word_of_ends(film, worst.Y);
  throw SolveError(message.str());
}

}  // namespace

StationaryResult solve_stationary(ContactFilm& film, const LoadCondition& load, const SolverOptions& options) {
  const ScopedStage stage("Stationary film");
  std::vector<SharedDiscretisation> coarser;  // next coarser first
  for (Discretisation* next = film.discretisation()->prepare_sequencing_grid();
       next && next->grid().nx() >= coarsest_nx; next = next->prepare_sequencing_grid()) {
    coarser.emplace_back(film.discretisation(), next);  // owned by the finest
  }

  StationaryResult result;
  const std::vector<ContactSurfaces> surfaces = surfaces_on(coarser, film);
  const Grid* before = nullptr;
  for (std::size_t n = coarser.size() + 1; n-- > 0;) {
    std::unique_ptr<ContactFilm> coarse_film;
    if (n > 0) {
      coarse_film = std::make_unique<ContactFilm>(coarser[n - 1], film.scales(), options.multigrid);
      coarse_film->set_surfaces(surfaces[n - 1]);
    }
    ContactFilm& present = coarse_film ? *coarse_film : film;
    StationaryNewton newton({&present}, options.newton);
    // The quantities of the last grid but one tell the error of the finest.
    if (n > 1) newton.aim_at(rough(newton.tolerance()));
    bool solved = false;
    if (before) {
      result.solution = interpolate(*before, present.grid(), result.solution);
      solved = solve_from_coarse(newton, present, load, result.solution);
    }
    if (!solved) {
      result.solution = dry_guess(present, load);
      solved = solve_from_dry(newton, present, load, result.solution);
    }
    if (!solved && n == 0) report_failure(present, newton);
    result.by_grid.push_back(newton.counts());
    if (n == 1 && solved) result.before = newton.quantities().front();
    if (n == 0) result.quantities = newton.quantities().front();
    // A coarse grid may be too coarse for a thin film to exist: then the next one starts from the dry pressure.
    before = solved ? &present.grid() : nullptr;
  }
  result.counts = result.by_grid.back();
  return result;
}

namespace {

StationaryResult result_of(StationaryNewton& newton, FilmSolution solution) {
  StationaryResult result;
  result.solution = std::move(solution);
  result.by_grid.push_back(newton.counts());
  result.counts = newton.counts();
  result.quantities = newton.quantities().front();
  return result;
}

}  // namespace

StationaryResult continue_stationary(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                     const FilmSolution& guess) {
  StationaryNewton newton({&film}, options.newton);
  FilmSolution solution = guess;
  if (load.kind == LoadCondition::Kind::displacement) solution.H0 = load.value;
  if (!solve_from(newton, load, solution)) return solve_stationary(film, load, options);
  return result_of(newton, std::move(solution));
}

std::optional<StationaryResult> improve_stationary(ContactFilm& film, const LoadCondition& load,
                                                   const SolverOptions& options, const FilmSolution& guess) {
  StationaryNewton newton({&film}, options.newton);
  FilmSolution solution = guess;
  if (!newton.solve(load, solution)) return {};
  return result_of(newton, std::move(solution));
}

FilmSolution solve_together(const std::vector<ContactFilm*>& films, const LoadCondition& load,
                            const SolverOptions& options, FilmSolution guess) {
  StationaryNewton newton(films, options.newton);
  if (load.kind == LoadCondition::Kind::displacement) guess.H0 = load.value;
  if (!solve_from(newton, load, guess)) report_failure(*films.front(), newton);
  return guess;
}

}  // namespace gearfilm

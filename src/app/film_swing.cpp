#include "app/film_swing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"
#include "gearfilm/film/discretisation.hpp"
#include "gearfilm/numerics/estimate.hpp"
#include "input/case_numerics.hpp"

namespace gearfilm {
namespace {

// Modes of films on few lines converge erratically, since the edge of what is full moves by whole cells
// (docs/verification.md, section 13). Their bars are what a doubling of the steps changes, and a part of the square of
// the step across, in half-widths b, at least.
constexpr double of_doubling = 3.0;             // in errors of second order
constexpr double least_of_frequency = 0.5;      // relative, of the step's square
constexpr double least_of_damping_ratio = 8.0;  // likewise
constexpr double fewest_cells_in_wave = 4.0;    // with fewer, all of the damping may be the grid's

double frequency(const Scales& scales, const SwingingMode& mode) {
  return mode.rate.imag() / (2.0 * std::numbers::pi * scales.time);
}

double damping_ratio(const SwingingMode& mode) { return -mode.rate.real() / std::abs(mode.rate); }

/// Nothing where the grid is too coarse for films, or for a mode.
std::optional<CoarserSwing> swing_on(const Case& problem, const SharedDiscretisation& films, double ratio,
                                     const Watcher& watcher) {
  try {
    RestingPair rest(problem, films);
    return CoarserSwing{swinging_mode(rest.pair(), rest.state(), {.watcher = watcher}), ratio};
  } catch (const SolveError&) {
    return {};
  }
}

std::optional<CoarserSwing> swing_on_coarser(const Case& problem, const SharedDiscretisation& fine,
                                             const Watcher& watcher) {
  if (Discretisation* half = fine->prepare_coarser()) {
    const SharedDiscretisation films(fine, half);  // owned by the finer one
    if (const auto found = swing_on(problem, films, 2.0, watcher)) return found;
  }
  GridShape shape = fine->grid().shape();
  NumericsCase numerics = problem.numerics;
  numerics.nx = shape.nx;
  numerics.ny = shape.ny();
  const SlightlyCoarser coarser = slightly_coarser(numerics);
  shape.nx = coarser.numerics.nx;
  shape.row_axis = shape.row_axis.with_whole_count(coarser.numerics.ny);
  if (shape.rows() < 2 * fine->grid().processes()) return {};
  return swing_on(problem, discretise(Grid(fine->grid().comm(), shape), problem), coarser.ratio, watcher);
}

}  // namespace

RestingPair::RestingPair(const Case& problem, const SharedDiscretisation& discretisation)
    : mesh_(mesh_model(problem, problem.steady.position, MeshGeometry::held)) {
  MeshMarch march = make_march(problem, discretisation, mesh_, unseen);
  march.start({});
  discretisation_ = march.discretisation();
  // Without the squeeze term the smoother alone does not do: all levels, as for stationary films.
  std::vector<LiveContact> contacts;
  for (const LiveContact& contact : march.contacts()) {
    films_.push_back(std::make_unique<ContactFilm>(discretisation_, problem.scales, problem.numerics.solver.multigrid));
    contacts.push_back({contact.number, films_.back().get()});
  }
  pair_.emplace(mesh_, contacts);
  const PairState at_rest = march.state();
  state_ = pair_->system().create_state();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    pair_->system().set_field(state_, k, values_of(at_rest.films[k], field::pressure));
  }
  pair_->set_motion(state_, at_rest.motion);
  H0_ = at_rest.motion.H0();
}

double FilmSwing::cells_in_wave() const { return 2.0 * std::numbers::pi / (mode.swings_in_passage * steps.x); }

FilmSwing film_swing(const Case& problem, RestingPair& rest, const Watcher& watcher) {
  const Grid& grid = rest.discretisation()->grid();
  const std::optional<CoarserSwing> coarser = swing_on_coarser(problem, rest.discretisation(), watcher);
  SwingOptions options{.watcher = watcher};
  if (coarser) options.guess = coarser->mode.rate;
  return {.mode = swinging_mode(rest.pair(), rest.state(), options),
          .steps = {grid.h_x(), grid.h_y() * problem.scales.hertz.ellipticity},
          .coarser = coarser};
}

void add_swing(const Scales& scales, const FilmSwing& swing, Summary& summary) {
  const auto add = [&](const std::string& name, double least, const auto& figure) {
    const double value = figure(swing.mode);
    summary[name] = value;
    summary[name + "_error"] = nullptr;
    if (!swing.coarser) return;
    const double error = of_doubling * estimate(value, figure(swing.coarser->mode), swing.coarser->ratio).error;
    summary[name + "_error"] = std::max(error, least * std::abs(value));
  };
  const double square = swing.steps.y * swing.steps.y;
  const bool waves = swing.cells_in_wave() >= fewest_cells_in_wave;
  add("film_frequency", least_of_frequency * square, [&](const SwingingMode& mode) { return frequency(scales, mode); });
  add("film_damping_ratio", waves ? least_of_damping_ratio * square : 1.0, damping_ratio);
  if (swing.on_stiff_films()) {
    const Summary& error = summary["film_damping_ratio_error"];
    const double ratio = std::abs(damping_ratio(swing.mode));
    summary["film_damping_ratio_bound"] = error.is_null() ? Summary() : Summary(ratio + error.get<double>());
  }
  summary["swings_in_passage"] = swing.mode.swings_in_passage;
  summary["swing_solutions"] = swing.mode.solutions;
  summary["swing_krylov_iterations"] = swing.mode.krylov_iterations;
}

std::string swing_remark(const FilmSwing& swing, const Summary& summary) {
  if (!swing.on_stiff_films()) {
    return swing.coarser ? "" : "the errors of the mode on films are not known, since no coarser grid has a mode";
  }
  const double dry = summary["f_n"].get<double>();
  const Summary& bound = summary["film_damping_ratio_bound"];
  return worded(std::setprecision(2), "while oil crosses half a contact the pair swings through ",
                swing.mode.swings_in_passage,
                " radians: films are stiff springs there. Their limit, the dry mode, has ", std::setprecision(5), dry,
                " Hz, from which the mode is ", std::setprecision(2),
                100.0 * (summary["film_frequency"].get<double>() / dry - 1.0), " % away; the damping ratio ",
                bound.is_null()
                    ? "has no bound, since no coarser grid has a mode"
                    : worded(std::setprecision(2), "is ", bound.get<double>(), " at most, with the error of the grid"));
}

}  // namespace gearfilm

#include "orbits/film_swing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film/discretisation.hpp"
#include "film/face_flow.hpp"
#include "gearfilm/error.hpp"
#include "numerics/estimate.hpp"

namespace gearfilm {
namespace {

// Modes of films on few lines converge erratically, since the edge of what is full moves by whole cells
// (docs/notes/2026-11-slow-pairs.md). Their bars are what a doubling of the steps changes, and a part of the square
// of the step across, in half-widths b, at least.
constexpr double of_doubling = 3.0;             // in errors of second order
constexpr double least_of_frequency = 0.5;      // relative, of the step's square
constexpr double least_of_damping_ratio = 8.0;  // likewise
constexpr double fewest_cells_in_wave = 4.0;    // with fewer, all of the damping may be the grid's

/// Nothing where the grid is too coarse for films, or for a mode.
std::optional<CoarserSwing> swing_on(const MeshModel& mesh, const PairNumerics& numerics,
                                     const SharedDiscretisation& films, double ratio, const SwingWatch& watch) {
  try {
    RestingPair rest(mesh, numerics, films);
    const CoarserSwing found{swinging_mode(rest.pair(), rest.state(), {.watcher = watch.watcher}), ratio};
    if (watch.on_coarser) watch.on_coarser(rest);
    return found;
  } catch (const SolveError&) {
    return {};
  }
}

std::optional<CoarserSwing> swing_on_coarser(const MeshModel& mesh, const PairNumerics& own,
                                             const SharedDiscretisation& fine, const SwingWatch& watch) {
  if (Discretisation* half = fine->prepare_coarser()) {
    const SharedDiscretisation films(fine, half);  // owned by the finer one
    if (const auto found = swing_on(mesh, own, films, 2.0, watch)) return found;
  }
  GridShape shape = fine->grid().shape();
  PairNumerics numerics = own;
  numerics.nx = shape.nx;
  numerics.ny = shape.ny();
  const SlightlyCoarser coarser = slightly_coarser(numerics);
  shape.nx = coarser.numerics.nx;
  if (!fine->grid().keeps_rows()) shape.row_axis = shape.row_axis.with_whole_count(coarser.numerics.ny);
  if (shape.rows() < 2 * fine->grid().processes()) return {};
  return swing_on(mesh, own, discretise(Grid(fine->grid().comm(), shape), own, mesh.scales), coarser.ratio, watch);
}

}  // namespace

RestingPair::RestingPair(MeshModel mesh, const PairNumerics& numerics, const SharedDiscretisation& discretisation)
    : mesh_(std::move(mesh)) {
  MeshMarch march = make_march(mesh_, numerics, discretisation, unseen);
  march.start({});
  discretisation_ = march.discretisation();
  // Without the squeeze term the smoother alone does not do: all levels, as for stationary films.
  std::vector<ActiveContact> contacts;
  for (const ActiveContact& contact : march.contacts()) {
    films_.push_back(std::make_unique<ContactFilm>(discretisation_, mesh_.scales, numerics.solver.multigrid));
    films_.back()->set_rates_in_wedge(rates_in_wedge(0.0));
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

FilmSwing film_swing(const MeshModel& mesh, const PairNumerics& numerics, RestingPair& rest, const SwingWatch& watch) {
  const Grid& grid = rest.discretisation()->grid();
  const std::optional<CoarserSwing> coarser = swing_on_coarser(mesh, numerics, rest.discretisation(), watch);
  SwingOptions options{.watcher = watch.watcher};
  if (coarser) options.guess = coarser->mode.rate;
  return {.mode = swinging_mode(rest.pair(), rest.state(), options),
          .steps = {grid.h_x(), grid.keeps_rows() ? 0.0 : grid.h_y() * mesh.scales.hertz.ellipticity},
          .coarser = coarser};
}

std::optional<double> SwingQuantities::damping_ratio_bound() const {
  return damping_ratio_error ? std::optional(std::abs(damping_ratio) + *damping_ratio_error) : std::nullopt;
}

SwingQuantities quantities_of(const FilmSwing& swing, const Scales& scales) {
  const auto coarser = swing.coarser ? std::optional(swing.coarser->mode.rate) : std::nullopt;
  return quantities_of(swing, scales, {.rate = swing.mode.rate, .coarser = coarser, .time = scales.time});
}

SwingQuantities quantities_of(const FilmSwing& swing, const Scales& scales, const ModeRates& rates) {
  using Rate = std::complex<double>;
  const auto frequency = [&](const Rate& s) { return s.imag() / (2.0 * std::numbers::pi * rates.time); };
  const auto damping_ratio = [](const Rate& s) { return 0.0 - s.real() / std::abs(s); };
  const auto error = [&](double least, const auto& quantity) -> std::optional<double> {
    if (!swing.coarser || !rates.coarser) return {};
    return std::max(of_doubling * estimate(quantity(rates.rate), quantity(*rates.coarser), swing.coarser->ratio).error,
                    least);
  };
  const double f = frequency(rates.rate), zeta = damping_ratio(rates.rate);
  // A wave of the film that oil carries away in a swing is 2 pi U/|s| long.
  const double passage =
      swing.mode.swings_in_passage * (std::abs(rates.rate) / rates.time) / (std::abs(swing.mode.rate) / scales.time);
  const bool waves = 2.0 * std::numbers::pi / (passage * swing.steps.x) >= fewest_cells_in_wave;
  const double square = swing.steps.y * swing.steps.y, of_films = std::abs(zeta - rates.damping_without_films);
  return {.frequency = f,
          .frequency_error = error(least_of_frequency * square * rates.share * std::abs(f), frequency),
          .damping_ratio = zeta,
          .damping_ratio_error = error((waves ? least_of_damping_ratio * square : 1.0) * of_films, damping_ratio)};
}

std::string swing_remark(const FilmSwing& swing, const SwingQuantities& quantities, double dry_frequency) {
  if (!swing.on_stiff_films()) {
    return swing.coarser ? "" : "the errors of the mode on films are not known, since no coarser grid has a mode";
  }
  const std::optional<double> bound = quantities.damping_ratio_bound();
  return worded(std::setprecision(2), "while oil crosses half a contact the pair swings through ",
                swing.mode.swings_in_passage,
                " radians: films are stiff springs there. Their limit, the dry mode, has ", std::setprecision(5),
                dry_frequency, " Hz, from which the mode is ", std::setprecision(2),
                100.0 * (quantities.frequency / dry_frequency - 1.0), " % away; the damping ratio ",
                bound ? worded(std::setprecision(2), "is ", *bound, " at most, with the error of the grid")
                      : "has no bound, since no coarser grid has a mode");
}

}  // namespace gearfilm

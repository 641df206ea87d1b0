#include "gearfilm/app/film_swing.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include "gearfilm/app/error_bar.hpp"
#include "gearfilm/ehl/discretisation.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

double frequency(const Scales& scales, const SwingingMode& mode) {
  return mode.rate.imag() / (2.0 * std::numbers::pi * scales.time);
}

double damping_ratio(const SwingingMode& mode) { return -mode.rate.real() / std::abs(mode.rate); }

/// On every second node of the grid; nothing where that is too coarse for films, or for a mode.
std::optional<SwingingMode> mode_on_coarser(const Case& problem, const SharedDiscretisation& fine,
                                            const Watcher& watcher) {
  const Discretisation* coarser = fine->coarser();
  if (!coarser) return {};
  try {
    RestingPair rest(problem, SharedDiscretisation(fine, coarser));
    return swinging_mode(rest.pair(), rest.state(), {.watcher = watcher});
  } catch (const SolveError&) {
    return {};
  }
}

}  // namespace

RestingPair::RestingPair(const Case& problem, const SharedDiscretisation& discretisation)
    : mesh_(mesh_model(problem, problem.steady.position, MeshGeometry::held)) {
  MeshMarch march =
      make_march(problem, discretisation, mesh_, [](const StepRecord&, const std::vector<LiveContact>&) {});
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
  H0_ = at_rest.motion.H0;
}

FilmSwing film_swing(const Case& problem, RestingPair& rest, const Watcher& watcher) {
  const std::optional<SwingingMode> coarser = mode_on_coarser(problem, rest.discretisation(), watcher);
  SwingOptions options{.watcher = watcher};
  if (coarser) options.guess = coarser->rate;
  return {swinging_mode(rest.pair(), rest.state(), options), coarser};
}

void add_swing(const Scales& scales, const FilmSwing& swing, Summary& summary) {
  const auto add = [&](const std::string& name, const auto& figure) {
    summary[name] = figure(swing.mode);
    std::optional<Estimate> error;
    if (swing.coarser) error = estimate(figure(swing.mode), figure(*swing.coarser));
    add_error_bar(summary, name, error);
  };
  add("film_frequency", [&](const SwingingMode& mode) { return frequency(scales, mode); });
  add("film_damping_ratio", damping_ratio);
  summary["swings_in_passage"] = swing.mode.swings_in_passage;
  summary["swing_solutions"] = swing.mode.solutions;
  summary["swing_krylov_iterations"] = swing.mode.krylov_iterations;
}

std::string stiff_film_remark(const FilmSwing& swing, const Summary& summary) {
  if (!swing.on_stiff_films()) return "";
  std::ostringstream text;
  text.precision(2);
  text << "while oil crosses half a contact the pair swings through " << swing.mode.swings_in_passage
       << " radians: films are stiff springs there. The limit of slower oil is the dry mode, ";
  text.precision(5);
  text << summary["f_n"].get<double>() << " Hz; ";
  const Summary& error = summary["film_damping_ratio_error"];
  text.precision(2);
  if (error.is_null()) {
    text << "the damping ratio has no bound, since a grid of half the nodes has no mode";
  } else {
    text << "of the damping ratio no more is known than that it is below "
         << std::abs(summary["film_damping_ratio"].get<double>()) + error.get<double>();
  }
  return text.str();
}

}  // namespace gearfilm

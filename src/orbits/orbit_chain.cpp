#include "orbits/orbit_chain.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<int> periods_from_neighbour("chain_periods_from_neighbour", 12, "periods of a search from a neighbour");
const Tuned<double> same_branch("chain_same_branch", 1.0, "change of the dry motion from point to point on one branch");
const Tuned<double> beside("chain_beside", 0.3, "distance of the motions on films and dry");

}  // namespace

void OrbitChain::keep(ChainLink found) {
  if (found.dry) film_shift_ = found.guess.motion.H0() - found.dry->start.H0();
  before_ = std::move(last_);
  last_ = std::move(found);
}

void OrbitChain::forget() {
  last_.reset();
  before_.reset();
}

DescribedOrbit OrbitChain::find_on_films(double value, const OrbitProblem& problem, const SharedDiscretisation& films,
                                         const SearchWatch& watch, Search& search) {
  std::optional<DryOrbit> dry;
  DescribedOrbit found = search_on_films({problem, films, value}, watch, dry, search);
  if (!dry) dry = dry_beside(problem.mesh, found.orbit.start.motion);
  keep({value, {found.orbit.start.motion, found.orbit.monodromy, found.orbit.end}, dry});
  return found;
}

DryPointFound OrbitChain::find_dry(double value, const DryWatch& watch) {
  const auto neighbour = last_ ? std::optional(BranchState{last_->guess.motion, last_->value}) : std::nullopt;
  DryPointFound found = find_dry_point(problem_at_, value, neighbour, watch);
  keep({value, {found.orbit.start, found.orbit.monodromy, {}}});
  return found;
}

/// The dry orbit next to one on films, if there is any.
std::optional<DryOrbit> OrbitChain::dry_beside(const MeshModel& mesh, const Motion& motion) const {
  Motion near = motion;
  near.H0() -= film_shift_;
  std::optional<DryOrbit> dry = follow_dry_orbit(mesh, typical_film_damping, near);
  if (dry && length(difference(dry->start, near)) > beside) dry.reset();
  return dry;
}

DescribedOrbit OrbitChain::search_on_films(const At& at, const SearchWatch& watch, std::optional<DryOrbit>& dry,
                                           Search& search) const {
  if (last_) {
    search.from_neighbour = true;
    OrbitProblem brief = at.problem;
    int& most = brief.search.options.max_periods;
    most = std::min<int>(most, periods_from_neighbour);
    try {
      return find_orbit_with_coarse_start(brief, at.films, from_neighbour(at, dry), watch);
    } catch (const SolveError& error) {
      search.neighbour_error = error.what();
    }
  }
  search.from_neighbour = false;
  dry = dry_start(at.problem.mesh);
  return find_orbit(at.problem, at.films, *dry, watch).own;
}

/// The neighbour moved as the dry pair's orbit moves from there to here, with its Jacobian; where the dry orbit
/// cannot be followed, extrapolated from the last two points.
OrbitGuess OrbitChain::from_neighbour(const At& at, std::optional<DryOrbit>& dry) const {
  OrbitGuess guess = last_->guess;
  if (last_->dry) {
    const Motion before = last_->dry->start;
    dry = follow_dry_orbit(at.problem.mesh, typical_film_damping, before);
    if (dry && length(difference(dry->start, before)) < same_branch) {
      guess.motion = moved(guess.motion, 1.0, difference(dry->start, before));
      guess.monodromy = dry->monodromy;
      return guess;
    }
    dry.reset();
  }
  guess.motion = extrapolated(at.value);
  return guess;
}

/// The motion of the last point, and how it changed from the one before.
Motion OrbitChain::extrapolated(double value) const {
  const Motion& last = last_->guess.motion;
  if (!before_) return last;
  const double part = (value - last_->value) / (last_->value - before_->value);
  const Motion step = moved(Motion::zero(last.freedoms()), part, difference(last, before_->guess.motion));
  if (length(step) >= beside) return last;
  return moved(last, 1.0, step);
}

}  // namespace gearfilm

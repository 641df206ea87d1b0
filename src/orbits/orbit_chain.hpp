// Periodic states at one value of a parameter after the other, each sought from those before it.
//
// A state on films begins with that of the neighbour, moved as the dry pair's orbit moves from there to here; where
// that fails, it is sought as without a neighbour.
#pragma once

#include "orbits/coarse_orbit.hpp"
#include "orbits/dry_sweep_point.hpp"
#include "orbits/settled_march.hpp"

namespace gearfilm {

/// A state that was found, as the beginning of the next.
struct ChainLink {
  double value = 0.0;
  OrbitGuess guess;
  std::optional<DryOrbit> dry{};  ///< the damped dry pair's orbit beside it
};

class OrbitChain {
public:
  explicit OrbitChain(ProblemAt problem_at) : problem_at_(std::move(problem_at)) {}

  /// A state has been found, here or by a program before.
  void keep(ChainLink found);
  /// None has been found: the next one is sought again.
  void forget();
  const std::optional<ChainLink>& last() const { return last_; }
  std::optional<ChainLink>& last() { return last_; }

  /// From where the last search on films began.
  struct Search {
    bool from_neighbour = false;  ///< else from the dry pair's orbit
    std::string neighbour_error;  ///< why not, where there was a neighbour
  };

  /// The state on films of the problem at a value, which becomes the last one. Throws SolveError where there is none.
  /// Collective.
  DescribedOrbit find_on_films(double value, const OrbitProblem& problem, const SharedDiscretisation& films,
                               const SearchWatch& watch, Search& search);
  /// The state of the dry pair at a value, which becomes the last one. Throws SolveError where there is none.
  DryPointFound find_dry(double value, const DryWatch& watch);

private:
  struct At {
    const OrbitProblem& problem;
    const SharedDiscretisation& films;
    double value;
  };

  std::optional<DryOrbit> dry_beside(const MeshModel& mesh, const Motion& motion) const;
  /// Leaves the dry orbit beside the one found.
  DescribedOrbit search_on_films(const At& at, const SearchWatch& watch, std::optional<DryOrbit>& dry,
                                 Search& search) const;
  OrbitGuess from_neighbour(const At& at, std::optional<DryOrbit>& dry) const;
  Motion extrapolated(double value) const;

  ProblemAt problem_at_;
  std::optional<ChainLink> last_, before_;
  double film_shift_ = 0.0;  ///< H_0 of the last orbit on films less that of the dry one beside it
};

}  // namespace gearfilm

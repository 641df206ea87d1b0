// The pair at rest on its films, and the mode in which it swings there, with what the grid leaves of errors.
//
// The same on every second node tells the error, and gives the first guess of the mode. Where the pair swings many
// times while oil crosses a contact, the films have no time to flow: they are stiff springs between the bodies.
#pragma once

#include <memory>
#include <optional>

#include "gearfilm/dynamics/lubricated_pair.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/orbits/dynamic_stiffness.hpp"
#include "gearfilm/output/summary.hpp"

namespace gearfilm {

/// The pair at the chosen position, its films in balance with the static force.
class RestingPair {
public:
  /// Throws SolveError where there are no such films. Collective.
  RestingPair(const Case& problem, const SharedDiscretisation& discretisation);

  LubricatedPair& pair() { return *pair_; }
  Vec state() const { return state_; }
  std::size_t contacts() const { return films_.size(); }
  double H0() const { return H0_; }
  /// Wider than that which was given, where a film had no room there.
  const SharedDiscretisation& discretisation() const { return discretisation_; }

private:
  MeshModel mesh_;
  SharedDiscretisation discretisation_;
  std::vector<std::unique_ptr<ContactFilm>> films_;
  std::optional<LubricatedPair> pair_;
  OwnedVec state_;
  double H0_ = 0.0;
};

struct FilmSwing {
  SwingingMode mode;
  std::optional<SwingingMode> coarser{};  ///< on every second node; nothing where there is none

  /// |s|/U from which films are springs.
  static constexpr double stiff_from = 10.0;
  bool on_stiff_films() const { return mode.swings_in_passage > stiff_from; }
};

/// The mode. Throws SolveError where there is none. Collective.
FilmSwing film_swing(const Case& problem, RestingPair& rest, const Watcher& watcher);

/// Frequency and damping ratio with their errors, null where the coarser grid has no mode; what the mode took.
void add_swing(const Scales& scales, const FilmSwing& swing, Summary& summary);

/// What is to be said of a mode on stiff films: its limit, and what is known of the damping. Empty for others.
std::string stiff_film_remark(const FilmSwing& swing, const Summary& summary);

}  // namespace gearfilm

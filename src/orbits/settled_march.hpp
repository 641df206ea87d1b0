// A march of the pair, dry or on its films, until it has settled or has not: where its motion is once a mesh period at
// the end, and what it settles on.
#pragma once

#include "orbits/orbit_search.hpp"
#include "orbits/poincare.hpp"

namespace gearfilm {

struct SettledMarch {
  std::vector<PoincarePoint> points;  ///< of its last mesh periods
  PairState end;
};

struct MarchLength {
  int mesh_periods = 0;
  int kept = 0;  ///< mesh periods at its end whose points are kept
};

/// The state in the scales of another speed, torque or mass: H_0 and V_0 in metres and seconds stay.
PairState rescaled(const PairState& state, const Scales& from, const Scales& to);

/// On films, from a state just after a contact has left, or from rest; without films they are stationary ones at first.
/// Throws SolveError where it cannot be marched, and what the watch throws. Collective.
SettledMarch march_on_films(const OrbitProblem& problem, const SharedDiscretisation& films,
                            const std::optional<PairState>& from, const MarchLength& length, const SearchWatch& watch);
/// March of the dry pair, from a motion just after a contact has left, or from rest.
SettledMarch march_dry(const OrbitProblem& problem, const std::optional<Motion>& from, const MarchLength& length,
                       const StopCheck& check_stop);

/// What the points say: extremes of forces over the static one and of the smallest film [-], and recurrence.
struct SettledQuantities {
  double largest_force = 0.0;   ///< on one contact
  double smallest_force = 0.0;  ///< of all contacts together
  double smallest_film = 0.0;
  bool contact_lost = false;
  std::optional<Recurrence> recurrence{};
  std::optional<int> repeats_every{};  ///< mesh periods; nothing where it does not repeat yet
  std::optional<int> settles_on{};     ///< the same, of the motion that it comes to repeat
  Motion settles_at{};                 ///< that motion once a mesh period: its last state
};
SettledQuantities quantities_of(const SettledMarch& march, const Scales& scales);

}  // namespace gearfilm

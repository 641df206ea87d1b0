// The periodic state of the lubricated gear pair in a few mesh periods.
//
// The film forgets within a fraction of a mesh period, so the map of the state over one period is nearly
// two-dimensional in (H_0, V_0), and close to that of the dry pair. Newton's method on it: from a guess (the dry pair's
// orbit, its H_0 shifted by the film, or the orbit at a neighbouring speed) with the guess's Jacobian, improved by
// Broyden's update after every period marched. The films themselves are carried on from period to period, and must
// repeat too. The change of the motion is the larger one of that of H_0 and of the way that the change of V_0 makes in
// half a free oscillation (where this is shorter than the unit of time: else of V_0). Where a step makes the defect
// worse, or its march fails, the next is half as long; where that does not help, the Jacobian is measured by
// differences; where that does not help either, the pair is marched on.
#pragma once

#include "dynamics/mesh_march.hpp"
#include "gearfilm/error.hpp"
#include "orbits/dry_orbit.hpp"

namespace gearfilm {

struct PeriodicOptions {
  double tolerance = 1e-4;       ///< on the change of (H_0, V_0) over one period [-]
  double film_tolerance = 1e-3;  ///< on film_change over one period [-]
  int max_periods = 40;          ///< marched before the search fails
  /// Periods after which the best one will do that repeats within four times the tolerances: for a search that is only
  /// to be begun with it. None: never.
  std::optional<int> enough_periods{};
  /// Periods over which the best has to come twice as near to repeating, else the search fails: for one that has
  /// another to follow it. None: all that are allowed.
  std::optional<int> patience{};
  double lead = 0.0;  ///< time before the orbit's end at which a state is kept, for a search on finer films
};

/// The marches went through, but did not come to repeat.
class NoPeriodicState : public SolveError {
public:
  using SolveError::SolveError;
};

/// Marches one period; the state some time before its end, where that is asked for. Time steps end there too, so that
/// only marches with the same lead are one map.
std::optional<PairState> march_period(MeshMarch& march, double lead);

/// Where a search begins, and its Jacobian. With a neighbour, films and all, the films follow from there to the motion;
/// without one, or where its grid has other steps, they start as stationary ones.
struct OrbitGuess {
  Motion motion;
  Monodromy monodromy;  ///< empty: zero
  std::optional<PairState> neighbour;
  /// By how much the neighbour is before the beginning of a period: it is marched there, and the motion follows from
  /// it.
  double lead = 0.0;
  /// How the motion at the beginning of a period follows from that so long before, where that is known: then films have
  /// this time to follow a step of the search.
  std::optional<Monodromy> lead_map{};
};

/// The guess from the dry orbit; film_shift: H_0 of a stationary film less that of the dry contact.
OrbitGuess guess_from(const DryOrbit& dry, double film_shift);

/// One marched period of the search.
struct SearchPeriod {
  int number = 0;
  double begin = 0.0;        ///< T
  double defect = 0.0;       ///< change of (H_0, V_0) [-]
  double film_defect = 0.0;  ///< largest change of any P [-]
  bool accepted = false;     ///< the periodic one: the search ends with it
  int halved_steps = 0;      ///< of its time steps, which keep it from repeating
};
using SearchObserver = std::function<void(const SearchPeriod&)>;

struct PeriodicOrbit {
  PairState start;                  ///< just after a contact has left
  PairState end;                    ///< one period later: the same within the defects
  std::optional<PairState> before;  ///< the state PeriodicOptions::lead before the end, if that is asked for
  std::optional<PairState> beside;  ///< a state some way off the orbit that a march has led to, if there was any
  double begin = 0.0;               ///< T at which the periodic period began
  double defect = 0.0;              ///< of the motion over that period
  double film_defect = 0.0;         ///< of the films
  int periods_used = 0;             ///< marched to find it
  Monodromy monodromy;              ///< of the motion, as the search knew it at its end
};

/// A better guess by one period and one Newton step, with films that were marched. The march must not have started.
/// Throws SolveError.
OrbitGuess improved_guess(MeshMarch& march, const OrbitGuess& guess, const SearchObserver& observer);

/// The march must not have started; its mesh starts (T = 0) just after a contact has left. Throws SolveError with the
/// defects reached where no orbit is found.
PeriodicOrbit find_periodic_orbit(MeshMarch& march, const OrbitGuess& guess, const PeriodicOptions& options,
                                  const SearchObserver& observer);

}  // namespace gearfilm

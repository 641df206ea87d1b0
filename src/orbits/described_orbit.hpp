// A periodic state of the lubricated pair, found and described: its quantities, its motion after every leaving, whether
// contact is lost in it, its transmission error, and how a disturbance dies away.
#pragma once

#include "dynamics/march_statistics.hpp"
#include "orbits/free_decay.hpp"
#include "orbits/orbit_search.hpp"
#include "orbits/pitch_films.hpp"
#include "orbits/spectrum.hpp"

namespace gearfilm {

struct DescribedOrbit {
  PeriodicOrbit orbit;
  PeriodQuantities quantities;               ///< of the periodic period
  std::vector<PitchFilm> pitch_films;        ///< of it
  std::vector<Motion> states_after_leaving;  ///< one a mesh period of it
  bool contact_lost = false;                 ///< in it
  SignalDeviation transmission_error;        ///< of H_0 over it
  std::optional<FreeDecay> decay;            ///< with the multipliers
  std::vector<double> memory;                ///< MeshMarch::memory() at its end
};

/// Throws SolveError where no orbit is found, and Stopped. Collective, as are the others.
DescribedOrbit find_described_orbit(const OrbitProblem& problem, const SharedDiscretisation& films,
                                    const OrbitGuess& guess, const SearchWatch& watch);

/// The guess after one period and one Newton step. Throws SolveError and Stopped.
OrbitGuess newton_step(const OrbitProblem& problem, const SharedDiscretisation& films, const OrbitGuess& guess,
                       const SearchWatch& watch);

/// The return of the pair pushed off an orbit that was found with other tolerances.
FreeDecay decay_from(const OrbitProblem& problem, const SharedDiscretisation& films, const DescribedOrbit& found,
                     const SearchWatch& watch);

/// The fewest mesh periods after which states repeat; as many as there are where none does before.
std::size_t true_order(const std::vector<Motion>& states, double tolerance);

}  // namespace gearfilm

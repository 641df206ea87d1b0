// The periodic state without a neighbour to come from: most of the search on every second node, at first with twice the
// time step. What a mesh period costs there is an eighth and a quarter. The step matters more than the grid for where
// in its swing the pair is when a period ends, and there lies what a search has to find. From the orbit with half of
// both the error of the problem's own grid and step is estimated; where there is none, from one with steps that are
// longer by about the root of two.
#pragma once

#include "orbits/described_orbit.hpp"

namespace gearfilm {

struct FoundOrbit {
  DescribedOrbit own{};                    ///< of the problem's own grid and step
  std::optional<DescribedOrbit> coarse{};  ///< the same with longer steps in space and time; absent where that has too
                                           ///< few nodes or no films
  double ratio = 2.0;                      ///< of those steps to the problem's own
  /// Where the coarse one has longer steps in space alone: the orbit on its grid with longer steps in time.
  std::optional<DescribedOrbit> longer_step{};
  static constexpr double step_ratio = 1.4;  ///< of those to the problem's own
  FilmDiscretisation discretisation{};
};

/// From the dry pair's orbit over those on the coarser grid, where it has any; then the multipliers are those of the
/// coarser grid with the problem's own step. The watch sees nothing of the coarser grid's marches but their periods.
/// Throws SolveError where nothing repeats; it says so where the coarser grid has an orbit. Collective.
FoundOrbit find_orbit(const OrbitProblem& problem, const SharedDiscretisation& films, const DryOrbit& dry,
                      const SearchWatch& watch);

/// Where half the grid gave no orbit, the orbit with steps that are longer by about the root of two; nothing, and the
/// reason to the watch, where there is none either. Collective.
void find_coarse_orbit(const OrbitProblem& problem, const SearchWatch& watch, MPI_Comm comm, FoundOrbit& found);

/// From the orbit of a neighbouring pair, films and all; the multipliers are those of the coarser grid too. Throws
/// SolveError. Collective.
DescribedOrbit find_orbit_with_coarse_start(const OrbitProblem& problem, const SharedDiscretisation& films,
                                            const OrbitGuess& neighbour, const SearchWatch& watch);

}  // namespace gearfilm

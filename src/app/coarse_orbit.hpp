// The periodic state without a neighbour to come from: most of the search on every second node, at first with twice the
// time step. What a mesh period costs there is an eighth and a quarter. The step matters more than the grid for where
// in its swing the pair is when a period ends, and there lies what a search has to find. From the orbit with half of
// both the error of the case's own grid and step is estimated; where there is none, from one with steps that are longer
// by about the root of two.
#pragma once

#include "app/orbit_run.hpp"

namespace gearfilm {

struct FoundOrbit {
  OrbitRun run{};
  std::optional<OrbitRun> coarse{};  ///< the same with longer steps in space and time; absent where that has too few
                                     ///< nodes or no films
  double ratio = 2.0;                ///< of those steps to the case's own
  /// Where the coarse one has longer steps in space alone: the orbit on its grid with longer steps in time.
  std::optional<OrbitRun> longer_step{};
  static constexpr double step_ratio = 1.4;  ///< of those to the case's own
  FilmDiscretisation discretisation{};
};

/// From the dry pair's orbit over those on the coarser grid, where it has any; then the multipliers are those of the
/// coarser grid with the case's own step. The observers see nothing of the coarser grid's marches but their periods.
/// Throws SolveError where nothing repeats; it says so where the coarser grid has an orbit. Collective.
FoundOrbit find_orbit(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                      const DryOrbit& dry, const OrbitObservers& observers);

/// Where half the grid told nothing, the orbit with steps that are longer by about the root of two; nothing, and the
/// reason to the observers, where there is none either. Collective.
void find_coarse_orbit(const Case& problem, const MeshModel& mesh, const OrbitObservers& observers, MPI_Comm comm,
                       FoundOrbit& found);

/// From the orbit of a neighbouring case, films and all; the multipliers are those of the coarser grid too. Throws
/// SolveError. Collective.
OrbitRun find_orbit_near(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                         const OrbitGuess& neighbour, const OrbitObservers& observers);

}  // namespace gearfilm

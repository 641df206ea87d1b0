// The numerical choices of a lubricated pair, or of one contact: first grid, discretisation, solvers and time steps;
// and how they become longer for a march that costs less.
#pragma once

#include <optional>

#include "dynamics/mesh_march.hpp"
#include "film/discretisation.hpp"
#include "film/expected_errors.hpp"
#include "grid/domain.hpp"
#include "grid/graded_rows.hpp"
#include "solver/stationary.hpp"

namespace gearfilm {

struct PairNumerics {
  Domain domain;                          ///< at first
  MarginRule margins;                     ///< by which it follows the contacts
  int nx = 0;                             ///< nodes along X
  int ny = 0;                             ///< nodes along Y
  std::optional<RowGrading> face_rows{};  ///< over the whole face in the place of ny equal rows
  FilmDiscretisation discretisation = FilmDiscretisation::fitted;
  SolverOptions solver;
  StepOptions steps;
  int step_levels = 0;  ///< multigrid levels in time steps; 0: chosen by the grid
  WideningObserver on_widening{};
};

/// The first grid.
GridShape grid_shape(const PairNumerics& numerics, const Scales& scales);
/// What all films on the first grid, or on another, share. Collective.
SharedDiscretisation discretise(MPI_Comm comm, const PairNumerics& numerics, const Scales& scales);
SharedDiscretisation discretise(const Grid& grid, const PairNumerics& numerics, const Scales& scales);
/// Steps along X and Y of the first grid, and of time; zero along Y where rows are graded, or single.
Steps steps_of(const PairNumerics& numerics);

/// Every second node, and twice the time step, of a grid that can be halved; nothing where too few nodes are left.
std::optional<PairNumerics> coarser(const PairNumerics& numerics);
/// Along which axes that grid has every second node: rows over a face stay.
Coarsening coarsened_along(const PairNumerics& numerics);

/// Numerics whose steps in space and time are longer by about the root of two; `ratio` is that along X and in time.
struct SlightlyCoarser {
  PairNumerics numerics;
  double ratio = 1.0;
};
SlightlyCoarser slightly_coarser(const PairNumerics& numerics);

/// A march of the lubricated pair. A store must outlive it.
MeshMarch make_march(const MeshModel& mesh, const PairNumerics& numerics, const SharedDiscretisation& films,
                     StepObserver observer, RunStore* store = nullptr);
/// The film at the pitch point under the whole static force, from a guess where there is one. Throws SolveError.
StationaryResult pitch_film(const Scales& scales, const PairNumerics& numerics, const SharedDiscretisation& films,
                            const FilmSolution* guess = nullptr);

}  // namespace gearfilm

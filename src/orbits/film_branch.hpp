// The lubricated pair's map of (H_0, V_0) as a branch of periodic motions needs it: marches of as many patterns of mesh
// periods as the order says, one after the other. The films are carried along: each march begins with those that the
// one before ended with, displaced to its motion, and they forget within a fraction of a mesh period.
//
// Derivatives are those of the damped dry pair at the same place, its H_0 lower by the film, plus a correction by
// Broyden's update, which makes them agree with what two marches one after the other say: a point of a branch costs two
// or three marches. At the point itself they are measured, by the return of the pair pushed off it (free_decay.hpp): up
// to four marches more; without, multipliers are approximate.
#pragma once

#include "dynamics/mesh_march.hpp"
#include "orbits/branch_point.hpp"

namespace gearfilm {

/// A march of the pair at a value of the parameter, whose period is that of an order; just after a contact has left,
/// one begins.
using MarchAt = std::function<MeshMarch(double parameter, int order, StepObserver observer)>;

struct FilmBranchOptions {
  double unit = 1.0;               ///< of CorrectorOptions
  double lost = 0.0;               ///< total force over the static one below which contact counts as lost
  double film_shift = 0.0;         ///< H_0 of the pair on its films less that of the dry one
  std::optional<PairState> films;  ///< of a state near the branch; without, the first march begins with stationary ones
};

/// dry: the same of the dry pair.
BranchMap film_branch_map(MarchAt march_at, BranchMap dry, const FilmBranchOptions& options);

}  // namespace gearfilm

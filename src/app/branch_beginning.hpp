// What a continuation follows and where it begins, with films and without.
#pragma once

#include <memory>

#include "app/dry_run.hpp"
#include "app/resumable_run.hpp"
#include "gearfilm/film/discretisation.hpp"
#include "gearfilm/orbits/continuation.hpp"

namespace gearfilm {

struct BranchBeginning {
  BranchMap map;
  BranchState start;                           ///< near a periodic state
  std::shared_ptr<const double> mesh_periods;  ///< marched by the map so far; null for the dry pair
};

/// The beginning of the dry pair's branch, watched at every evaluation of its map. The case must outlive what is
/// returned. Throws SolveError where no periodic state is found, and what the watch throws.
BranchBeginning dry_beginning(const Case& problem, const DryWatch& watch);
/// Of the pair on films of this discretisation, marched under a run, which must outlive it too. Throws SolveError where
/// no periodic state is found, and Stopped.
BranchBeginning film_beginning(const Case& problem, const SharedDiscretisation& films, ResumableRun& run);

}  // namespace gearfilm

// What a continuation of the pair follows and where it begins, on films and dry.
#pragma once

#include <memory>

#include "orbits/continuation.hpp"
#include "orbits/dry_sweep_point.hpp"

namespace gearfilm {

struct BranchBeginning {
  BranchMap map;
  BranchState start;                           ///< near a periodic state
  std::shared_ptr<const double> mesh_periods;  ///< marched by the map so far; null for the dry pair
};

/// Where a branch begins, and the change of the parameter that counts as much as 1 of q and v.
struct BranchEntry {
  double from = 0.0;
  double unit = 1.0;
};

/// The beginning of the dry pair's branch, watched at every evaluation of its map. Throws SolveError where no periodic
/// state is found, and what the watch throws.
BranchBeginning dry_beginning(const ProblemAt& problem_at, const BranchEntry& entry, const DryWatch& watch);
/// The beginning of the branch of the pair on films. The watch must outlive what is returned. Throws SolveError where
/// no periodic state is found, and what the watch throws. Collective.
BranchBeginning film_beginning(const ProblemAt& problem_at, const BranchEntry& entry, MPI_Comm comm,
                               const SearchWatch& watch);

}  // namespace gearfilm

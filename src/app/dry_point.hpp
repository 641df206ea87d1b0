// A point of a sweep of the dry pair's periodic states, from a state at another point.
#pragma once

#include <string>

#include "app/dry_run.hpp"
#include "gearfilm/orbits/branch_point.hpp"

namespace gearfilm {

struct DryPointFound {
  DryOrbit orbit;
  std::string start;  ///< from where, as the results of a point say it
};

/// problem: of the sweep. neighbour: a periodic state at another value of what is varied; without one the search begins
/// as `gearfilm periodic` does. Throws SolveError where nothing is found, and what the watch throws.
DryPointFound find_dry_point(const Case& problem, double value, const std::optional<BranchState>& neighbour,
                             const DryWatch& watch);

/// Followed from a state at another value, or at this one; nothing where its branch does not reach here.
std::optional<DryOrbit> follow_to_point(const Case& problem, double value, const BranchState& from,
                                        const DryWatch& watch);

}  // namespace gearfilm

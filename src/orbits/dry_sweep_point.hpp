// A point of a sweep of the dry pair's periodic states, from a state at another point.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "orbits/branch_point.hpp"
#include "orbits/orbit_search.hpp"

namespace gearfilm {

/// The pair's problem at a value of what is varied. Throws SolveError or InputError where there is none.
using ProblemAt = std::function<OrbitProblem(double value)>;

struct DryPointFound {
  DryOrbit orbit;
  std::string start;  ///< from where: rest, given motion, neighbour, march from neighbour
};

/// neighbour: a periodic state at another value; without one the search begins with the problem's start, or from rest.
/// Throws SolveError where nothing is found, and what the watch throws.
DryPointFound find_dry_point(const ProblemAt& problem_at, double value, const std::optional<BranchState>& neighbour,
                             const DryWatch& watch);

/// Followed from a state at another value, or at this one; nothing where its branch does not reach here.
std::optional<DryOrbit> follow_to_point(const ProblemAt& problem_at, double value, const BranchState& from,
                                        const DryWatch& watch);

}  // namespace gearfilm

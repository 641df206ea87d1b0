// The dry pair's periodic motion followed from one value of a parameter to another.
//
//   x(lambda + d) is sought next to x + d dx/dlambda, the tangent of the branch (branch_point.hpp)
// A step is halved where Newton's method does not converge, where it comes to a motion that is not next to the
// prediction, or where the tangent turns by much: so the motion stays on its branch as long as there is one, however
// near others are, and where the branch turns round or ends there is nothing.
#pragma once

#include "orbits/dry_branch.hpp"
#include "orbits/dry_shooting.hpp"

namespace gearfilm {

/// Whether a motion is still the one that was followed, after Newton's method.
bool is_same_motion(const Motion& a, const Motion& b);

/// from: a periodic motion of that order, and its parameter. Nothing where its branch does not reach `to`.
std::optional<Motion> follow_dry_branch(const MeshAt& mesh_at, int order, double damping_ratio, const BranchState& from,
                                        double to, const DryWatch& watch);

}  // namespace gearfilm

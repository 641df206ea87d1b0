// The damped dry pair's map of (H_0, V_0) as a branch of periodic motions needs it, over as many patterns of mesh
// periods as the order says, with its exact derivatives (dry_flow.hpp).
#pragma once

#include "dynamics/dry_flow.hpp"
#include "orbits/branch_point.hpp"

namespace gearfilm {

/// The pair at a value of the parameter, which just after a contact has left begins a period.
using MeshAt = std::function<MeshModel(double parameter)>;

/// unit: of CorrectorOptions.
BranchMap dry_branch_map(MeshAt mesh_at, double damping_ratio, double unit);

}  // namespace gearfilm

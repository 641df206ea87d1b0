#include "orbits/dry_branch.hpp"

namespace gearfilm {

BranchMap dry_branch_map(MeshAt mesh_at, double damping_ratio, double unit) {
  constexpr double part = 1e-6;
  return [mesh_at = std::move(mesh_at), damping_ratio, unit](const BranchState& at, int order) {
    const MeshModel mesh = mesh_at(at.parameter);
    const DryFlow flow(mesh, mesh_at(at.parameter + part * unit), part, damping_ratio);
    const DryFlowEnd end = flow(at.motion, order * mesh.pattern);
    MapValue value;
    for (int n = 1; n <= order; ++n) value.states.push_back(end.states[n * mesh.pattern - 1]);
    value.by_motion = end.by_start;
    value.by_parameter = {end.by_parameter.q / unit, end.by_parameter.v / unit};
    value.largest_force = end.extremes.largest_force / mesh.scales.static_force;
    value.smallest_force = end.extremes.smallest_force / mesh.scales.static_force;
    value.least_approach = end.extremes.least_approach;
    return value;
  };
}

}  // namespace gearfilm

// Newton's method for the periodic motion of the dry pair.
//
//   P(x) = x ,   x = (H_0, V_0) where a period begins, P: the motion over one of its periods (dry_flow.hpp)
// by PETSc's SNES with the exact derivative of P. Converged where |P(x) - x| is below 1e-9 for every free oscillation
// in a period.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "dynamics/dry_flow.hpp"
#include "mesh/mesh_model.hpp"

namespace gearfilm {

/// Called with the mesh periods that a search of the dry pair is about to compute, the same on all processes; may throw
/// to end it.
using DryWatch = std::function<void(int mesh_periods)>;

class DryMap {
public:
  /// Mesh and watch must outlive the map.
  DryMap(const MeshModel& mesh, double damping_ratio, const DryWatch& watch)
      : mesh_(mesh), damping_ratio_(damping_ratio), watch_(watch) {}

  const MeshModel& mesh() const { return mesh_; }
  double damping_ratio() const { return damping_ratio_; }
  const DryWatch& watch() const { return watch_; }
  DryMap at_damping(double zeta) const { return {mesh_, zeta, watch_}; }
  /// Free oscillations in a period, but no less than one.
  double oscillations() const;

  /// That of the last start is kept. Throws SolveError where the motion is not finite.
  const DryFlowEnd& operator()(const Motion& start) const;

private:
  const MeshModel& mesh_;
  double damping_ratio_;
  const DryWatch& watch_;
  mutable std::optional<std::pair<Motion, DryFlowEnd>> last_{};
};

/// The periodic motion to which Newton's method comes from a guess; nothing where it does not converge.
std::optional<Motion> shoot(const DryMap& map, const Motion& guess);

}  // namespace gearfilm

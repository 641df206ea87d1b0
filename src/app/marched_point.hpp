// A march as a point of a sweep: where its motion is once a mesh period when it has settled, or has not.
#pragma once

#include "gearfilm/dynamics/pair_state.hpp"
#include "gearfilm/input/case.hpp"
#include "gearfilm/orbits/poincare.hpp"
#include "output/checkpoint.hpp"
#include "output/summary.hpp"

namespace gearfilm {

struct MarchedPoint {
  std::vector<PoincarePoint> points;  ///< of its last mesh periods
  PairState end;
};

/// The same state in the scales of another speed, torque or mass: H_0 and V_0 in metres and seconds stay.
PairState rescaled(const PairState& state, const Scales& from, const Scales& to);

/// Called after every step of films, or every mesh period of the dry pair; is_new: not what was kept of an earlier run.
using MarchWatch = std::function<void(double T, bool is_new)>;

/// Begins at a state just after a contact has left, or at rest; without films they are stationary ones. films,
/// checkpoint: none for the dry pair. Throws SolveError where it cannot be marched, and what the watch throws.
MarchedPoint march_point(const Case& problem, const MeshModel& mesh, const SharedDiscretisation& films,
                         const std::optional<PairState>& from, Checkpoint* checkpoint, const MarchWatch& watch);

/// In SI.
Summary marched_summary(const Case& problem, const MarchedPoint& point);

}  // namespace gearfilm

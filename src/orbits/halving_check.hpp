// Whether a search on a coarser grid costs more than it saves.
//
// Over a pattern of many mesh periods, the first of them tell: where films on a coarser grid do not follow a motion
// that loses contact, each step that has to be halved costs as much as a hundred.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/step_record.hpp"
#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {

inline const Tuned<double> most_halved("search_most_halved", 0.05,
                                       "part of the first time steps on a coarser grid that may have to be halved");

/// Thrown by the check.
class TooManyHalved : public SolveError {
public:
  using SolveError::SolveError;
};

/// An observer of the steps of one search on a coarser grid.
inline StepObserver halving_check(const MeshModel& mesh) {
  constexpr int first_steps = 100;
  if (mesh.periods() == 1) return unseen;
  const double look_for = 3.0 * mesh.path.mesh_period();
  return [look_for, begin = HUGE_VAL, steps = 0, halved = 0](const StepRecord& record,
                                                             const std::vector<ActiveContact>&) mutable {
    begin = std::min(begin, record.T);
    if (record.T - begin > look_for) return;
    ++steps;
    halved += record.halvings > 0 ? 1 : 0;
    if (steps < first_steps || halved <= most_halved * steps) return;
    throw TooManyHalved(halved, " of the first ", steps, " time steps had to be halved");
  };
}

}  // namespace gearfilm

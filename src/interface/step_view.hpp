// How a step of a march is shown to an observer of the public face.
#pragma once

#include "dynamics/step_record.hpp"
#include "gearfilm/simulation.hpp"

namespace gearfilm {

/// Its films are borrowed: valid while these are.
Step step_of(const MeshModel& mesh, const StepRecord& record, const std::vector<ActiveContact>& contacts);

}  // namespace gearfilm

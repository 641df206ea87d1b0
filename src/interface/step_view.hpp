// How a step of a march is shown to an observer of the public face.
#pragma once

#include "dynamics/step_record.hpp"
#include "gearfilm/simulation.hpp"

namespace gearfilm {

/// Valid while the records and films are.
Step step_of(const Scales& scales, const StepRecord& record, const std::vector<LiveContact>& contacts);

}  // namespace gearfilm

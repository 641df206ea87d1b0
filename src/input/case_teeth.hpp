// The teeth of a case: reliefs, errors and compliance from its parameters.
#pragma once

#include "gear/teeth.hpp"
#include "input/parameter_values.hpp"
#include "input/worn_flanks.hpp"

namespace gearfilm {

/// Throws InputError for reliefs given twice or by half, and for teeth that cannot be.
Teeth read_teeth(const ParameterValues& values, const SpurGearPair& pair, const LineOfAction& line,
                 const WornFlanks& worn);

}  // namespace gearfilm

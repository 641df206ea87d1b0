// Fatigue of the flanks of a case's pair.
#pragma once

#include <optional>

#include "fatigue/fatigue_model.hpp"
#include "input/parameter_values.hpp"

namespace gearfilm {

/// Absent without fatigue.criterion. deepest: depth of the stresses [m]; 0 where there are none. Throws InputError.
std::optional<FatigueModel> read_fatigue(const ParameterValues& values, double deepest);

}  // namespace gearfilm

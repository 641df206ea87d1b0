// Stresses below the films of a case.
#pragma once

#include <optional>

#include "input/parameter_values.hpp"
#include "traction/film_stress.hpp"

namespace gearfilm {

/// Absent without stress.model. Throws InputError.
std::optional<StressModel> read_stress(const ParameterValues& values);

}  // namespace gearfilm

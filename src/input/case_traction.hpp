// Friction and heat of a case.
#pragma once

#include <optional>

#include "input/parameter_values.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// Absent where no law of friction is given. Throws InputError for laws without what they need.
std::optional<TractionModel> read_traction(const ParameterValues& values);

}  // namespace gearfilm

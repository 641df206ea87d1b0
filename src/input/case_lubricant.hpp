// The oil of a case: its laws, and what heat meets in it.
#pragma once

#include <optional>

#include "input/parameter_values.hpp"
#include "lubricant/thermal_oil.hpp"

namespace gearfilm {

/// Throws InputError for laws without what they need, and for constants that make no oil.
Lubricant read_lubricant(const ParameterValues& values);

/// Absent where nothing says how the viscosity falls with temperature: neither lubricant.temperature_viscosity nor a
/// law that knows it by itself.
std::optional<ThermalOil> read_thermal_oil(const ParameterValues& values);

}  // namespace gearfilm

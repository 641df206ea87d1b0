// Stresses below the films of a case.
#pragma once

#include <optional>

#include "input/parameter_values.hpp"
#include "traction/film_stress.hpp"

namespace gearfilm {

/// Absent without stress.model. Throws InputError.
std::optional<StressModel> read_stress(const ParameterValues& values);

/// Hertz pressure of the reference contact at which the gear with the smaller yield stress first yields [Pa]; absent
/// without one.
std::optional<double> first_yield_pressure(const ParameterValues& values, const Scales& scales);

}  // namespace gearfilm

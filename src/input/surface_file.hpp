// Measured profiles of flanks in files: two columns, or ASCII files of ISO 25178-71 (.sdf).
#pragma once

#include <utility>
#include <vector>

#include "input/parameter_values.hpp"

namespace gearfilm {

/// Points s, z [m] of the file that a parameter names, ascending in s; middle: s at which the middle of a profile lies
/// whose file does not say where it was taken. Throws InputError.
std::vector<std::pair<double, double>> read_surface(const ParameterValues& values, const std::string& name,
                                                    double middle);

}  // namespace gearfilm

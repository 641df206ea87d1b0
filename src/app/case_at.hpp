// A case at another value of one of its parameters: sweeps and continuations go from value to value.
#pragma once

#include <string>

#include "gearfilm/input/case.hpp"

namespace gearfilm {

/// On the grid that the case has by itself. Throws InputError where there is no such pair.
Case case_at(const Case& problem, const std::string& parameter, double value);

}  // namespace gearfilm

// Values that are legal but odd: nothing forbids them, and most often a unit is wrong.
#pragma once

#include <string>
#include <vector>

#include "input/case.hpp"

namespace gearfilm {

/// One line each, what, the value, and why it is odd; empty for a usual case.
std::vector<std::string> plausibility_warnings(const CaseInput& problem);

}  // namespace gearfilm

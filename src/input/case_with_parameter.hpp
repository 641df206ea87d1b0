// A case at another value of one of its parameters: sweeps and continuations go from value to value.
#pragma once

#include <string>

#include "input/case.hpp"
#include "orbits/dry_sweep_point.hpp"

namespace gearfilm {

/// On the grid that the case has by itself. Throws InputError where there is no such pair.
CaseInput case_with_parameter(const CaseInput& problem, const std::string& parameter, double value);

/// The case of a point of its sweep: of basins all are of the case itself.
CaseInput case_of_sweep(const CaseInput& problem, double value);
/// The searches of these. The case must outlive what is returned.
ProblemAt problems_of_sweep(const CaseInput& problem);

}  // namespace gearfilm

// A case at another value of one of its parameters: sweeps and continuations go from value to value, and contacts that
// come to the edges of the face have films over all of it.
#pragma once

#include <functional>
#include <string>

#include "input/case.hpp"
#include "orbits/dry_sweep_point.hpp"

namespace gearfilm {

/// The case with another value, on the grid that it has by itself. Throws InputError where there is no such pair.
CaseInput case_with_parameter(const CaseInput& problem, const std::string& parameter, double value);

inline constexpr const char* whole_face_parameter = "grid.whole_face";
/// The case with films over the whole face, on which no contact comes to its edges.
CaseInput over_whole_face(const CaseInput& problem);

/// The case of a point of its sweep: of basins all are of the case itself.
CaseInput case_of_sweep(const CaseInput& problem, double value);
/// The cases of the points of a sweep (case_of_sweep), by value; the last few are remembered. The sweep's case must
/// outlive what is returned.
using CaseAt = std::function<CaseInput(double value)>;
CaseAt cases_of_sweep(const CaseInput& problem);
/// Searches for the periodic states of such cases, by value; the last few are remembered.
ProblemAt problems_of_sweep(const CaseAt& case_at);

/// The search for the case's periodic state at another speed, by the speed over that of the case. The case must outlive
/// it.
ProblemAt problems_at_speeds(const CaseInput& problem);

}  // namespace gearfilm

// What summaries say of shafts that tilt under the static force.
#pragma once

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Nothing where no gear is on two bearings at a distance.
void add_tilt(const CaseInput& problem, Summary& summary);
/// A line for the screen; empty where there is nothing.
std::string tilt_line(const CaseInput& problem);

/// The table of the manual, in Markdown.
std::string tilt_markdown();

}  // namespace gearfilm

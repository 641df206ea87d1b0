// What `wear` leaves behind: the steps in which flanks wear, and their depths at its end.
#pragma once

#include "dynamics/worn_flanks.hpp"
#include "output/results_file.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// What has been worn when a step begins, for its summary.
Summary worn_summary(const WornPair& worn);
/// A step: what a mesh period takes, in full precision, so that a run goes on from it to the bit.
Summary period_wear_summary(const PeriodWear& period, double revolutions);
PeriodWear read_period_wear(const Summary& step);

/// One row a step in /wear/steps, and one a place in /wear/pinion and /wear/wheel.
void write_wear(ResultsFile& file, const Summary& steps, const WornPair& worn, const std::array<double, 2>& base_radii);

/// What is in these, in the manual's Markdown.
std::string wear_markdown();

}  // namespace gearfilm

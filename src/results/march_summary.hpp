// What summaries say of a march in time, in SI.
#pragma once

#include "dynamics/march_statistics.hpp"
#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Quantities of one mesh period.
Summary period_summary(const Scales& scales, const PeriodQuantities& period);
/// The grid that a run ended on, widened or not, in the units of the case's parameters.
Summary grid_summary(const Scales& scales, const GridShape& shape);
/// Grid, step, force and mesh period of a run on the pair, and what they are in the manual's Markdown.
void add_run(const CaseInput& problem, const MeshModel& mesh, Summary& summary);
std::string run_markdown();
/// All of a march: its periods, their extremes, events and losses of contact.
Summary march_summary(const CaseInput& problem, const MeshModel& mesh, const MarchStatistics& statistics);

}  // namespace gearfilm

// What summaries say of a march in time, in SI.
#pragma once

#include "dynamics/march_statistics.hpp"
#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Figures of one mesh period.
Summary period_summary(const Scales& scales, const PeriodFigures& period);
/// The grid that a run ended on, widened or not, in the units of the case's parameters.
Summary grid_summary(const Scales& scales, const GridShape& shape);
/// All of a march: its periods, their extremes, events and losses of contact.
Summary march_summary(const CaseInput& problem, const MeshModel& mesh, const MarchStatistics& statistics);

}  // namespace gearfilm

// What summaries say of a periodic state, in SI.
#pragma once

#include "input/case.hpp"
#include "orbits/orbit_errors.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Quantities and states of an orbit, and its multipliers where they are known.
Summary orbit_summary(const MeshModel& mesh, const DescribedOrbit& found);

/// The columns of the table /sweep among these, and all of them in the manual's Markdown.
std::vector<TableColumn> orbit_columns();
std::string orbit_markdown();

/// Both multipliers as four columns of a table; floquet: of a summary, or null.
std::vector<TableColumn> multiplier_columns();
void add_multipliers_to_row(const Summary& floquet, std::vector<double>& row);

/// Multipliers, and the free oscillation they mean, added to a summary.
void add_multipliers(const MeshModel& mesh, const Multipliers& pair, Summary& summary);

/// `_error` and `_extrapolated` of its quantities, null where nothing is known.
void add_errors(const std::vector<OrbitError>& errors, const Scales& scales, Summary& summary);

/// All of `periodic` but for its spectrum and the dry pair's orbit.
Summary periodic_summary(const CaseInput& problem, const MeshModel& mesh, const FoundOrbit& found,
                         const std::vector<OrbitError>& errors);

/// The undamped dry pair's orbit, for comparison; null where that of a damped pair leads to none, or where the pair
/// swings so often in a mesh period that an orbit without damping says nothing.
Summary dry_summary(const MeshModel& mesh);

}  // namespace gearfilm

// Results from the motion of a march once a mesh period: the points of /history/poincare of `transient`, the points of
// each march of a sweep, whether the march repeats, and how it settles.
#pragma once

#include "mesh/mesh_model.hpp"
#include "orbits/settled_march.hpp"
#include "output/results_file.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Writes the table /history/poincare. Collective.
void write_poincare(ResultsFile& file, const MeshModel& mesh, bool lubricated,
                    const std::vector<PoincarePoint>& points);
/// Whether a march repeats and how it settles; nothing where it has too few points.
void add_recurrence(const std::vector<PoincarePoint>& points, Summary& summary);

/// A march of a sweep, in SI.
Summary marched_summary(const SettledMarch& march, const Scales& scales, bool lubricated);
/// The columns of such marches in /sweep, and of their points in /diagram.
std::vector<TableColumn> marched_columns(bool lubricated);
std::vector<TableColumn> diagram_columns(bool lubricated);

std::string poincare_markdown();

}  // namespace gearfilm

// Fatigue of both flanks: what contacts leave in them on their way, over the flank and the depth.
#pragma once

#include "dynamics/flank_recorder.hpp"
#include "fatigue/flank_map.hpp"
#include "orbits/orbit_passages.hpp"
#include "output/results_file.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"
#include "results/section_result.hpp"

namespace gearfilm {

/// One flank, on all processes. Arrays are [point][depth], in Pa.
struct FlankResult {
  std::vector<double> s;       ///< points along the flank, from the base circle [m]
  FlankMap map;                ///< of the worst passage and row at each place
  std::vector<double> safety;  ///< by dang_van; empty without a limit
  std::vector<FlankMap> rows;  ///< of the worst passage, by rows
  WorstSection section;        ///< below the contact when stresses are largest
};

struct FlankResults {
  std::vector<double> z;  ///< [m]
  std::vector<double> y;  ///< of the rows [m]
  std::array<FlankResult, body_count> of_body;
  double risk = 0.0;            ///< of both flanks, mean over passages (risk.hpp); of several rows their integral
  double reference_risk = 0.0;  ///< of static load shares
};

/// By these passages, at least one. rest: the same pair just after a contact has left, whose fatigue is to be judged;
/// grid: of its films, wide enough for them. Collective.
FlankResults flank_results(const Grid& grid, const MeshModel& rest, const std::vector<Passage>& passages);

/// Results of a periodic motion, which is marched once more. Throws SolveError and Stopped. Collective.
FlankResults flank_results(const OrbitProblem& problem, const SharedDiscretisation& films, const PeriodicOrbit& orbit,
                           const StopCheck& check_stop);

/// Beside the maps of surfaces, whose points are the same (contact_map_result.hpp); sections in /section/pinion and
/// /section/wheel. Collective.
void write_flanks(ResultsFile& file, const FatigueModel& fatigue, const FlankResults& results);

/// Largest values and least safeties added to a summary; null where nothing is known.
void add_flanks(const MeshModel& mesh, const std::optional<FlankResults>& results, Summary& summary);
/// The keys that are columns in the table of a sweep.
std::vector<TableColumn> flank_columns();
/// All of them in the manual's Markdown.
std::string flank_markdown();

}  // namespace gearfilm

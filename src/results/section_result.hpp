// Stresses in sections below contacts, in the results: of a film at rest, and of the worst moment of passages.
#pragma once

#include "dynamics/flank_recorder.hpp"
#include "output/results_file.hpp"

namespace gearfilm {

/// Von Mises stress and components at [depth][line] as datasets of a group, their names with an ending. The stresses
/// are on the first process. Collective.
void write_stresses(ResultsFile& file, const std::string& group, const std::string& ending, int depths, int lines,
                    const std::vector<Stress>& stresses);

/// The section of one body at the moment of some passages at which its von Mises stress is largest.
struct WorstSection {
  double xi = 0.0;             ///< of the contact [m]
  std::size_t row = 0;         ///< of the passages
  std::vector<double> x;       ///< [m]
  std::vector<Stress> stress;  ///< on the first process, [depth][line] [Pa]
};

/// The worst section of one body in passages whose depths the processes share by these ranges. Collective.
WorstSection worst_section(MPI_Comm comm, std::span<const int> depth_ranges, const std::vector<Passage>& passages,
                           std::size_t body);

}  // namespace gearfilm

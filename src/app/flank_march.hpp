// The stresses that the last contact of a march which goes over its whole path leaves in the flanks.
//
// Only of the last mesh periods, in which that contact is there, films are kept with the checkpoint, for a program that
// goes on.
#pragma once

#include "output/checkpoint.hpp"
#include "output/section_replay.hpp"
#include "results/flank_result.hpp"

namespace gearfilm {

class FlankMarch {
public:
  /// mesh: of the march, which keeps sections where fatigue is to be judged; end: T of its end. Both must outlive it.
  FlankMarch(MPI_Comm comm, Checkpoint& checkpoint, const MeshModel& mesh, double end);

  void step(const StepRecord& record, const std::vector<ActiveContact>& contacts);

  /// Stresses that the last whole passage of the march so far has left in both flanks; nothing before any contact has
  /// gone the whole way. rest, grid: the pair at rest and the last grid of its films, for flank_results. Collective.
  std::optional<FlankResults> results(const Grid& grid, const MeshModel& rest) const;

private:
  Checkpoint& checkpoint_;
  const MeshModel& mesh_;
  double begin_;  ///< T from which on films are kept
  FlankRecorder recorder_;
  SectionReplay replay_;
};

/// Makes a model keep sections where fatigue is to be judged.
inline void keep_sections(MeshModel& mesh) {
  if (mesh.fatigue && mesh.stress) mesh.stress->keeps_sections = true;
}

}  // namespace gearfilm

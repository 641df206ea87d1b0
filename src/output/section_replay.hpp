// Sections below films that an earlier program has computed: what is kept of these films, and the sections again.
//
// A march that is to judge fatigue attaches to its checkpoint what the surfaces carried whenever stresses were
// computed. A program that goes on makes the same sections of it, to the bit.
#pragma once

#include "output/film_snapshot.hpp"

namespace gearfilm {

/// Sections below the contacts whose stresses were computed at this step; nothing where there are none. Collective.
std::optional<FilmSnapshot> section_snapshot(const MeshModel& mesh, const StepRecord& record,
                                             const std::vector<ActiveContact>& contacts);

class SectionReplay {
public:
  SectionReplay(MPI_Comm comm, const MeshModel& mesh) : comm_(comm), mesh_(mesh) {}

  /// The sections of a contact of such a snapshot. Collective.
  SectionRecords sections(const FilmSnapshot& snapshot, const ContactSnapshot& contact);

private:
  MPI_Comm comm_;
  const MeshModel& mesh_;
  std::optional<Grid> grid_;
  std::unique_ptr<RowStress> rows_;
};

}  // namespace gearfilm

#include "app/flank_march.hpp"

namespace gearfilm {

// The last whole passage ends within a mesh period of the march's end.
FlankMarch::FlankMarch(MPI_Comm comm, Checkpoint& checkpoint, const MeshModel& mesh, double end)
    : checkpoint_(checkpoint),
      mesh_(mesh),
      begin_(mesh.path.time_after(mesh.path.mesh_periods(end) - mesh.path.line().contact_ratio() - 1.1)),
      recorder_(mesh, false),
      replay_(comm, mesh) {}

void FlankMarch::step(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  if (!mesh_.fatigue || record.T < begin_) return;
  if (!record.replayed) {
    if (const auto films = section_snapshot(mesh_, record, contacts)) checkpoint_.attach(*films);
    recorder_.observe(record, contacts);
    return;
  }
  if (const auto films = checkpoint_.recall_sections(record.T)) {
    for (const ContactSnapshot& contact : films->contacts) {
      recorder_.add(contact.number, replay_.sections(*films, contact));
    }
  }
  recorder_.end_others(record.contacts);
}

std::optional<FlankResults> FlankMarch::results(const Grid& grid, const MeshModel& rest) const {
  const Passage* whole = recorder_.last_whole();
  if (!mesh_.fatigue || !whole) return {};
  return flank_results(grid, rest, {*whole});
}

}  // namespace gearfilm

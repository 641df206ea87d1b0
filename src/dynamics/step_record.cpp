#include "dynamics/step_record.hpp"

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& figures) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, figures_of({mesh.scales, contact, figures})};
}

std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<LiveContact>& contacts, double T,
                                           const std::vector<FilmFigures>& figures) {
  std::vector<ContactRecord> records;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const MeshedContact contact = mesh.contact(contacts[k].number, T);
    ContactMoment at{mesh.scales, contact, figures[k], {}, mesh.roughness};
    if (mesh.traction) {
      at.traction = with_powers_times(mesh.load_factor(), traction_of(*mesh.traction, contacts[k])->figures);
    }
    records.push_back({contacts[k].number, contact.position, figures_of(at)});
  }
  return records;
}

}  // namespace gearfilm

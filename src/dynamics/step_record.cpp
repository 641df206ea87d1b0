#include "gearfilm/dynamics/step_record.hpp"

#include <algorithm>

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& figures) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, figures_of({mesh.scales, contact, figures})};
}

std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<int>& numbers, double T,
                                           const std::vector<ContactFilm*>& films,
                                           const std::vector<FilmFigures>& figures) {
  std::vector<ContactRecord> records;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const MeshedContact contact = mesh.contact(numbers[k], T);
    ContactMoment at{mesh.scales, contact, figures[k], {}, mesh.roughness};
    if (mesh.traction) at.traction = traction(*mesh.traction, *films[k], velocities_of(mesh.scales, contact)).figures;
    records.push_back({numbers[k], contact.position, figures_of(at)});
  }
  return records;
}

std::vector<int> numbers_of(const std::vector<LiveContact>& contacts) {
  std::vector<int> numbers(contacts.size());
  std::ranges::transform(contacts, numbers.begin(), &LiveContact::number);
  return numbers;
}

}  // namespace gearfilm

#include "gearfilm/dynamics/step_record.hpp"

#include <algorithm>

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& film) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, figures_of({mesh.scales, contact, film})};
}

std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<int>& numbers, double T,
                                           const std::vector<FilmFigures>& films) {
  std::vector<ContactRecord> records;
  for (std::size_t k = 0; k < numbers.size(); ++k) records.push_back(contact_record(mesh, numbers[k], T, films[k]));
  return records;
}

std::vector<int> numbers_of(const std::vector<LiveContact>& contacts) {
  std::vector<int> numbers(contacts.size());
  std::ranges::transform(contacts, numbers.begin(), &LiveContact::number);
  return numbers;
}

}  // namespace gearfilm

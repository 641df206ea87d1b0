#include "output/film_snapshot.hpp"

namespace gearfilm {
namespace {

void add_traction(const MeshModel& mesh, const LiveContact& live, ContactSnapshot& snapshot) {
  const std::shared_ptr<const Traction> traction = traction_of(*mesh.traction, live);
  for (NamedField& field : traction_fields(live.film->grid(), traction->fields))
    snapshot.fields.push_back(std::move(field));
}

}  // namespace

std::vector<NamedField> traction_fields(const Grid& grid, const TractionFields& traction) {
  std::vector<NamedField> fields;
  for (const auto& kind : field::traction) {
    const std::vector<double>& values = traction.*kind.values;
    if (values.empty()) continue;
    fields.push_back({std::string(kind.field.name), Field<double>(grid)});
    fields.back().values.load(values);
  }
  return fields;
}

// The film itself has the pressure of the step; what else a contact carries is in its fields.
FilmSnapshot film_snapshot(const MeshModel& mesh, const StepRecord& record, const std::vector<LiveContact>& contacts) {
  FilmSnapshot snapshot{record.T, {}};
  if (!contacts.empty()) snapshot.shape = contacts.front().film->grid().shape();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    ContactSnapshot contact{contacts[k].number, record.contacts[k].position, {}};
    contact.fields.push_back({std::string(field::pressure.name), contacts[k].film->total_pressure()});
    contact.fields.push_back({std::string(field::thickness.name), contacts[k].film->thickness()});
    for (const auto& [name, values] : contacts[k].fields) {
      if (field_named(name).dataset.empty() || name == field::pressure.name) continue;
      Field<double> field(contacts[k].film->grid());
      field.load(values);
      contact.fields.push_back({name, std::move(field)});
    }
    if (mesh.traction) add_traction(mesh, contacts[k], contact);
    snapshot.contacts.push_back(std::move(contact));
  }
  return snapshot;
}

}  // namespace gearfilm

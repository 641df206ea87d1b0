#include "output/film_snapshot.hpp"

namespace gearfilm {
std::vector<NamedField> film_fields(const ContactFilm& film, const TractionFields* traction) {
  std::vector<NamedField> fields = {{std::string(field::pressure.name), film.total_pressure()},
                                    {std::string(field::thickness.name), film.thickness()}};
  if (film.state().rough) {
    Field<double> carried(film.grid());
    for (int i = 0; i < film.grid().nx(); ++i) {
      for (int j = 0; j < film.grid().y_count(); ++j) {
        carried.row(i)[j] = asperity_pressure(*film.state().rough, film.total_pressure(), i, j);
      }
    }
    fields.push_back({std::string(field::film_pressure.name), film.film_pressure()});
    fields.push_back({std::string(field::asperity_pressure.name), std::move(carried)});
    fields.push_back({std::string(field::mean_gap.name), film.mean_gap()});
  }
  if (!traction) return fields;
  for (const auto& kind : field::traction) {
    const std::vector<double>& values = traction->*kind.values;
    if (values.empty()) continue;
    fields.push_back({std::string(kind.field.name), Field<double>(film.grid())});
    fields.back().values.load(values);
  }
  return fields;
}

std::vector<NamedField> stress_fields(const std::optional<StressModel>& model, const ContactFilm& film,
                                      const TractionFields* traction, const std::vector<int>& rows) {
  std::vector<NamedField> fields;
  if (!model || !model->whole_fields) return fields;
  const std::vector<double> none;
  const auto values = von_mises_fields(*model, film, traction ? traction->shear_stress : none, rows);
  for (std::size_t body = 0; body < values.size(); ++body) {
    fields.push_back({std::string(field::von_mises[body].name), Field<double>(film.grid())});
    fields.back().values.load(values[body]);
  }
  return fields;
}

// The film itself has the pressure of the step; what else a contact carries is in its fields.
FilmSnapshot film_snapshot(const MeshModel& mesh, const StepRecord& record,
                           const std::vector<ActiveContact>& contacts) {
  FilmSnapshot snapshot{record.T, {}};
  if (!contacts.empty()) snapshot.shape = contacts.front().film->grid().shape();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    ContactSnapshot contact{contacts[k].number, record.contacts[k].position, {}};
    const std::shared_ptr<const Traction> traction =
        mesh.traction ? friction_of_step(*mesh.traction, contacts[k], record.T) : nullptr;
    const TractionFields* friction = traction ? &traction->fields : nullptr;
    const ContactFilm& film = *contacts[k].film;
    contact.fields = film_fields(film, friction);
    const std::vector<int> rows = mesh.stress ? stress_rows(*mesh.stress, film.grid().row_axis()) : std::vector<int>();
    for (NamedField& field : stress_fields(mesh.stress, film, friction, rows)) {
      contact.fields.push_back(std::move(field));
    }
    for (const auto& [name, values] : contacts[k].fields) {
      if (field_named(name).dataset.empty() || name == field::pressure.name) continue;
      Field<double> field(contacts[k].film->grid());
      field.load(values);
      contact.fields.push_back({name, std::move(field)});
    }
    snapshot.contacts.push_back(std::move(contact));
  }
  return snapshot;
}

}  // namespace gearfilm

#include "output/section_replay.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

constexpr std::string_view shear_stress = field::traction[0].field.name;

const Field<double>* find(const ContactSnapshot& contact, std::string_view name) {
  const auto found = std::ranges::find(contact.fields, name, &NamedField::name);
  return found == contact.fields.end() ? nullptr : &found->values;
}

bool is_needed(const NamedField& field) {
  return field.name == field::pressure.name || field.name == field::film_pressure.name ||
         field.name == field::thickness.name || field.name == field::mean_gap.name || field.name == shear_stress;
}

}  // namespace

std::optional<FilmSnapshot> section_snapshot(const MeshModel& mesh, const StepRecord& record,
                                             const std::vector<ActiveContact>& contacts) {
  FilmSnapshot snapshot{.T = record.T, .contacts = {}, .of_sections = true};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (!contacts[k].stress || !contacts[k].stress->is_of(record.T)) continue;
    const ContactFilm& film = *contacts[k].film;
    snapshot.shape = film.grid().shape();
    const std::shared_ptr<const Traction> traction =
        mesh.traction ? friction_of_step(*mesh.traction, contacts[k], record.T) : nullptr;
    ContactSnapshot contact{contacts[k].number, record.contacts[k].position, {}};
    for (NamedField& field : film_fields(film, traction ? &traction->fields : nullptr)) {
      if (is_needed(field)) contact.fields.push_back(std::move(field));
    }
    snapshot.contacts.push_back(std::move(contact));
  }
  return snapshot.contacts.empty() ? std::nullopt : std::optional(std::move(snapshot));
}

SectionRecords SectionReplay::sections(const FilmSnapshot& snapshot, const ContactSnapshot& contact) {
  if (!grid_ || grid_->shape() != snapshot.shape) {
    grid_.emplace(comm_, snapshot.shape);
    rows_ =
        std::make_unique<RowStress>(*grid_, row_options(*mesh_.stress, stress_rows(*mesh_.stress, grid_->row_axis())));
  }
  const Field<double>* oil = find(contact, field::film_pressure.name);
  const Field<double>* gap = find(contact, field::mean_gap.name);
  const Field<double>* shear = find(contact, shear_stress);
  const Field<double>& total = *find(contact, field::pressure.name);
  std::vector<double> stress(shear ? grid_->local_size() : 0);
  if (shear) shear->store(stress);
  const SurfaceLoads loads = loads_below(
      mesh_.scales, *grid_, {total, oil ? *oil : total, gap ? *gap : *find(contact, field::thickness.name)}, stress);
  return section_records(mesh_.scales, *rows_, rows_->evaluate(loads), contact.position);
}

}  // namespace gearfilm

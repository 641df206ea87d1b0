#include "dynamics/step_record.hpp"

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmQuantities& quantities) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, quantities_of({mesh.scales, contact, quantities})};
}

std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<ActiveContact>& contacts, double T,
                                           const std::vector<FilmQuantities>& quantities) {
  std::vector<ContactRecord> records;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const MeshedContact contact = mesh.contact(contacts[k].number, T);
    QuantityInputs at{mesh.scales, contact, quantities[k], {}, mesh.roughness, mesh.wear, mesh.load_factor()};
    std::shared_ptr<const Traction> friction;
    if (mesh.traction) {
      friction = traction_of(*mesh.traction, contacts[k]);
      *contacts[k].friction = {T, friction};
      at.traction = with_powers_times(mesh.load_factor(), friction->quantities);
    }
    at.rating = mesh.rating.get();
    if (contacts[k].stress) {
      at.stress = contacts[k].stress->observe(*contacts[k].film, contact, T,
                                              friction ? friction->fields.shear_stress : std::vector<double>());
    }
    records.push_back({contacts[k].number, contact.position, quantities_of(at)});
  }
  return records;
}

}  // namespace gearfilm

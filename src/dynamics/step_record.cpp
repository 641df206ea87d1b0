#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& film) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, figures_of({mesh.scales, contact, film})};
}

}  // namespace gearfilm

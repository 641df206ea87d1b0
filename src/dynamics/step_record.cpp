#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

ContactRecord contact_record(const ContactPath& path, const Scales& scales, int contact, double T,
                             const FilmFigures& film) {
  const double xi = path.position(contact, T);
  return {contact, xi, figures_of({scales, path.conditions(contact, T), film, xi, &path.line(), path.pinion_speed()})};
}

}  // namespace gearfilm

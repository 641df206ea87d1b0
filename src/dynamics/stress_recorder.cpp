#include "dynamics/stress_recorder.hpp"

#include <cmath>

namespace gearfilm {

const ContactStress& StressRecorder::observe(const ContactFilm& film, const MeshedContact& contact, double T,
                                             std::span<const double> shear_stress) {
  // Velocities over that of entrainment, u_i/u_m = U +- S/2; T is in a/u_m.
  const double faster = contact.conditions.entrainment + 0.5 * std::abs(contact.conditions.sliding);
  constexpr double round_off = 1e-9;
  if (last_ && faster * (T - *last_) < model_.every - round_off) return stress_;
  last_ = T;
  const FilmSections sections = film_sections(model_, film, shear_stress, stress_rows(model_, film.grid().row_axis()));
  if (model_.keeps_sections) {
    records_ = section_records(film.scales(), *sections.rows, *sections.stresses, contact.position);
  }
  return stress_ = contact_stress(film.scales(), sections);
}

}  // namespace gearfilm

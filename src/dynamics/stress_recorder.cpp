#include "dynamics/stress_recorder.hpp"

#include <cmath>

namespace gearfilm {

const ContactStress& StressRecorder::observe(const ContactFilm& film, const ContactConditions& conditions, double T,
                                             std::span<const double> shear_stress) {
  // Velocities over that of entrainment, u_i/u_m = U +- S/2; T is in a/u_m.
  const double faster = conditions.entrainment + 0.5 * std::abs(conditions.sliding);
  constexpr double round_off = 1e-9;
  if (last_ && faster * (T - *last_) < model_.every - round_off) return stress_;
  last_ = T;
  section_ = film_section(model_, film, shear_stress, film.grid().row_axis().central());
  return stress_ = contact_stress(film.scales(), section_);
}

}  // namespace gearfilm

#include "orbits/pitch_films.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

PitchFilmRecorder::PitchFilmRecorder(const MeshModel& mesh) : mesh_(mesh) {
  if (mesh.inertia > 0.0 && mesh.periods() == 1)
    reach_ = std::min(0.25 / mesh.frequency(), mesh.path.mesh_period() / 40.0);
}

void PitchFilmRecorder::add(const StepRecord& record) {
  if (record.dT == 0.0) return;
  const double pitch = mesh_.path.time_at(0.0);
  for (const ContactRecord& contact : record.contacts) {
    const double time = mesh_.path.time_at(contact.position) - pitch;
    if (std::abs(time) < reach_) recorded_.push_back({record.T, {time, contact.quantities}});
  }
}

std::vector<PitchFilm> PitchFilmRecorder::within(double T_begin, double T_end) const {
  const double margin = 1e-9 * mesh_.path.mesh_period();
  std::vector<PitchFilm> films;
  for (const Recorded& recorded : recorded_) {
    if (recorded.T > T_begin + margin && recorded.T < T_end + margin) films.push_back(recorded.film);
  }
  std::ranges::sort(films, {}, &PitchFilm::time);
  return films;
}

std::optional<double> largest_relative_change(const std::vector<PitchFilm>& films, const std::vector<PitchFilm>& other,
                                              std::size_t quantity) {
  const auto value = [quantity](const PitchFilm& film) { return film.quantities.values[quantity]; };
  std::optional<double> largest;
  for (const PitchFilm& film : films) {
    const auto after = std::ranges::lower_bound(other, film.time, {}, &PitchFilm::time);
    if (after == other.begin() || after == other.end()) continue;
    const auto before = std::prev(after);
    const double part = (film.time - before->time) / (after->time - before->time);
    const double change = std::lerp(value(*before), value(*after), part) / value(film) - 1.0;
    if (!largest || std::abs(change) > std::abs(*largest)) largest = change;
  }
  return largest;
}

}  // namespace gearfilm

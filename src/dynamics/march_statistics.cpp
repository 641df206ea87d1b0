#include "gearfilm/dynamics/march_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double lost_force_ratio = 0.02;

}  // namespace

void MarchStatistics::add(const StepRecord& record, bool lubricated) {
  add_events(record);
  add_loss(record);
  if (record.dT > 0.0) add_to_period(record, lubricated);
}

void MarchStatistics::add_events(const StepRecord& record) {
  std::vector<int> contacts;
  for (const ContactRecord& contact : record.contacts) contacts.push_back(contact.contact);
  const auto missing_in = [](const std::vector<int>& list, int contact) {
    return std::find(list.begin(), list.end(), contact) == list.end();
  };
  const bool first = present_.empty();
  for (int contact : present_) {
    if (missing_in(contacts, contact)) events_.push_back({MeshEvent::Kind::exit, contact, record.T, record.motion});
  }
  for (int contact : contacts) {
    if (first || !missing_in(present_, contact)) continue;
    events_.push_back({MeshEvent::Kind::entry, contact, record.T, record.motion});
    entered_ = contact;
  }
  present_ = std::move(contacts);
}

void MarchStatistics::add_loss(const StepRecord& record) {
  const bool lost = record.pressure_integral() < lost_force_ratio * static_force_;
  if (lost && !lost_) losses_.push_back({record.T, record.T, 0.0});
  if (lost) {
    ContactLoss& loss = losses_.back();
    loss.end = record.T;
    for (const ContactRecord& contact : record.contacts) {
      loss.largest_central_film = std::max(loss.largest_central_film, contact.figures.central_film);
    }
  }
  lost_ = lost;
}

bool MarchStatistics::contact_lost(double T_begin, double T_end) const {
  return std::any_of(losses_.begin(), losses_.end(),
                     [&](const ContactLoss& loss) { return loss.begin <= T_end && loss.end > T_begin; });
}

void MarchStatistics::add_to_period(const StepRecord& record, bool lubricated) {
  // A step that ends within round-off of the period's end still belongs to it.
  const auto index = static_cast<std::size_t>(std::max(0.0, std::ceil(record.T / mesh_period_ - 1e-9) - 1.0));
  const double total = record.pressure_integral();
  if (index >= periods_.size()) {
    periods_.resize(index + 1);
    periods_.back().smallest_total = total;
    pitch_distance_ = HUGE_VAL;
  }
  PeriodFigures& period = periods_[index];
  period.end = record.motion;
  period.largest_total = std::max(period.largest_total, total);
  period.smallest_total = std::min(period.smallest_total, total);
  for (const ContactRecord& contact : record.contacts) {
    period.largest_integral = std::max(period.largest_integral, contact.figures.pressure_integral);
    period.largest_pressure = std::max(period.largest_pressure, contact.figures.largest_pressure);
  }
  if (lubricated) add_films(record, period);
  period.steps += 1;
  period.contact_steps += static_cast<int>(record.contacts.size());
  period.newton += record.newton;
  period.krylov += record.krylov;
  period.wall_seconds += record.wall_seconds;
}

void MarchStatistics::add_films(const StepRecord& record, PeriodFigures& period) {
  for (const ContactRecord& contact : record.contacts) {
    const FilmPair films{contact.figures.central_film, contact.figures.smallest_film};
    period.smallest_film = std::min(period.smallest_film.value_or(films.smallest), films.smallest);
    if (std::abs(contact.position) < pitch_distance_) {
      pitch_distance_ = std::abs(contact.position);
      period.at_pitch = films;
    }
    if (entered_ == contact.contact) {
      period.at_entry = films;
      entered_.reset();
    }
  }
}

}  // namespace gearfilm

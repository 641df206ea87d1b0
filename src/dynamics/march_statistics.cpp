#include "dynamics/march_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

/// Where a contact is, for the reductions that ask for it.
struct Moments {
  bool nearest_pitch = false;
  bool entered = false;
};

/// Whether a reduction takes a record: that of an event, which takes no time, counts among extremes only.
bool counts(const StepRecord& record, Reduction reduction) {
  return record.dT > 0.0 || reduction == Reduction::largest || reduction == Reduction::smallest;
}

std::optional<double> reduced(const std::optional<double>& kept, Reduction reduction, double value,
                              const Moments& moments = {}) {
  switch (reduction) {
    case Reduction::largest:
      return std::max(kept.value_or(value), value);
    case Reduction::smallest:
      return std::min(kept.value_or(value), value);
    case Reduction::sum:
      return kept.value_or(0.0) + value;
    case Reduction::steps:
      return kept.value_or(0.0) + 1.0;
    case Reduction::at_pitch:
      return moments.nearest_pitch ? value : kept;
    case Reduction::at_entry:
      return moments.entered ? value : kept;
    default:  // last; means are those of steps only: add_to_mean
      return value;
  }
}

/// Of a step; of contacts the sum.
double value_in(const StepRecord& record, const PeriodQuantity& quantity) {
  if (!quantity.of_contact) return step_quantities[quantity.source].value(record);
  double sum = 0.0;
  for (const ContactRecord& contact : record.contacts) sum += contact.quantities.values[quantity.source];
  return sum;
}

}  // namespace

void MarchStatistics::add(const StepRecord& record, const AvailableModels& given) {
  // A film that enters is that of its place at once where the bodies are in balance.
  const bool is_event = record.dT == 0.0 && !present_.empty() && !periods_.empty();
  add_events(record);
  add_loss(record);
  if (record.dT > 0.0 || (is_event && !given.inertia)) add_to_period(record, given);
  for (std::size_t n = 0; n < period_quantities.size(); ++n) {
    if (period_quantities[n].reduction == Reduction::mean) last_[n] = value_in(record, period_quantities[n]);
  }
}

void MarchStatistics::add_to_mean(std::optional<double>& mean, std::size_t quantity, double value, double dT) {
  const double step = 0.5 * (last_[quantity] + value) * dT;
  mean = (mean.value_or(0.0) * elapsed_ + step) / (elapsed_ + dT);
}

void MarchStatistics::add_events(const StepRecord& record) {
  std::vector<int> contacts;
  for (const ContactRecord& contact : record.contacts) contacts.push_back(contact.number);
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
      loss.largest_central_film = std::max(loss.largest_central_film, contact.quantities["h_central"]);
    }
  }
  lost_ = lost;
}

bool MarchStatistics::contact_lost(double T_begin, double T_end) const {
  return std::any_of(losses_.begin(), losses_.end(),
                     [&](const ContactLoss& loss) { return loss.begin <= T_end && loss.end > T_begin; });
}

void MarchStatistics::add_to_period(const StepRecord& record, const AvailableModels& given) {
  // A step that ends within round-off of the period's end still belongs to it.
  const double passed = course_.phase(record.T) / mesh_period_;
  const auto index = static_cast<std::size_t>(std::max(0.0, std::ceil(passed - 1e-9) - 1.0));
  if (index >= periods_.size()) {
    periods_.resize(index + 1);
    pitch_distance_ = HUGE_VAL;
    elapsed_ = 0.0;
  }
  PeriodQuantities& period = periods_[index];
  for (std::size_t n = 0; n < period_quantities.size(); ++n) {
    const PeriodQuantity& quantity = period_quantities[n];
    if (!given.has(quantity.needs) || !counts(record, quantity.reduction)) continue;
    if (quantity.reduction == Reduction::mean) {
      add_to_mean(period.values[n], n, value_in(record, quantity), record.dT);
    } else if (!quantity.of_contact) {
      period.values[n] = reduced(period.values[n], quantity.reduction, value_in(record, quantity));
    }
  }
  elapsed_ += record.dT;
  for (const ContactRecord& contact : record.contacts) add_contact(record, contact, given, period);
}

void MarchStatistics::add_contact(const StepRecord& record, const ContactRecord& contact, const AvailableModels& given,
                                  PeriodQuantities& period) {
  const bool is_step = record.dT > 0.0;
  const Moments moments{is_step && std::abs(contact.position) < pitch_distance_, is_step && entered_ == contact.number};
  if (moments.nearest_pitch) pitch_distance_ = std::abs(contact.position);
  if (moments.entered) entered_.reset();
  for (std::size_t n = 0; n < period_quantities.size(); ++n) {
    const PeriodQuantity& quantity = period_quantities[n];
    if (!quantity.of_contact || quantity.reduction == Reduction::mean) continue;
    if (!given.has(quantity.needs) || !counts(record, quantity.reduction)) continue;
    period.values[n] =
        reduced(period.values[n], quantity.reduction, contact.quantities.values[quantity.source], moments);
  }
}

}  // namespace gearfilm

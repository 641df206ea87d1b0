#include "dynamics/flank_recorder.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

// Contacts begin and end at events, but their first and last sections may be a few steps off.
constexpr double near_end = 0.02;  // of the path of contact

}  // namespace

void FlankRecorder::observe(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  for (const ActiveContact& contact : contacts) {
    if (contact.stress && contact.stress->is_of(record.T)) add(contact.number, contact.stress->records());
  }
  end_others(record.contacts);
}

void FlankRecorder::add(int number, const std::array<SectionRecord, body_count>& sections) {
  const auto found = passages_.try_emplace(number, empty()).first;
  for (std::size_t body = 0; body < body_count; ++body) {
    FlankHistory& history = found->second[body];
    const auto same = [&](const SectionRecord& known) { return known.xi == sections[body].xi; };
    if (std::ranges::none_of(history.records(), same)) history.add(sections[body]);
  }
}

void FlankRecorder::end_others(const std::vector<ContactRecord>& present) {
  if (keep_all_) return;
  std::erase_if(passages_, [&](auto& entry) {
    const auto is_there = [&](const ContactRecord& contact) { return contact.number == entry.first; };
    if (std::ranges::any_of(present, is_there)) return false;
    if (is_whole(entry.second)) last_whole_ = std::move(entry.second);
    return true;
  });
}

bool FlankRecorder::is_whole(const Passage& passage) const {
  const auto& records = passage[pinion_body].records();
  const double margin = near_end * (line_.exit() - line_.entry());
  return !records.empty() && records.front().xi < line_.entry() + margin && records.back().xi > line_.exit() - margin;
}

std::vector<Passage> FlankRecorder::of_period(int mesh_periods) const {
  std::map<int, Passage> teeth;
  for (const auto& [number, passage] : passages_) {
    const int tooth = ((number % mesh_periods) + mesh_periods) % mesh_periods;
    Passage& whole = teeth.try_emplace(tooth, empty()).first->second;
    for (std::size_t body = 0; body < body_count; ++body) {
      for (const SectionRecord& record : passage[body].records()) whole[body].add(record);
    }
  }
  std::vector<Passage> found;
  found.reserve(teeth.size());
  for (auto& [tooth, passage] : teeth) found.push_back(std::move(passage));
  return found;
}

}  // namespace gearfilm

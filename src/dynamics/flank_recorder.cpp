#include "dynamics/flank_recorder.hpp"

#include <algorithm>

#include "fatigue/flank_map.hpp"

namespace gearfilm {
namespace {

// Contacts begin and end at events, but their first and last sections may be a few steps off.
constexpr double near_end = 0.02;  // of the path of contact

}  // namespace

FlankRecorder::FlankRecorder(const MeshModel& mesh, bool keep_all)
    : line_(mesh.path.line()), keep_all_(keep_all), paths_{FlankPath(line_, true), FlankPath(line_, false)} {
  if (!mesh.fatigue || !mesh.stress->all_rows) return;
  for (std::size_t body = 0; body < body_count; ++body) {
    points_[body] = flank_points(paths_[body], mesh.fatigue->flank_points);
  }
}

void FlankRecorder::observe(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  for (const ActiveContact& contact : contacts) {
    if (contact.stress && contact.stress->is_of(record.T)) add(contact.number, contact.stress->records());
  }
  end_others(record.contacts);
}

std::array<FlankHistory, body_count>& FlankRecorder::row_of(Passage& passage, std::size_t row) const {
  if (row == passage.size()) passage.push_back({FlankHistory(paths_[0]), FlankHistory(paths_[1])});
  return passage[row];
}

void FlankRecorder::add(int number, const SectionRecords& sections) {
  Passage& passage = passages_[number];
  for (std::size_t row = 0; row < sections.size(); ++row) {
    for (std::size_t body = 0; body < body_count; ++body) {
      FlankHistory& history = row_of(passage, row)[body];
      const SectionRecord& section = sections[row][body];
      const auto same = [&](const SectionRecord& known) { return known.xi == section.xi; };
      if (std::ranges::any_of(history.records(), same)) continue;
      history.add(points_[body].empty() ? section : at_points(section, paths_[body], points_[body]));
    }
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
  if (passage.empty()) return false;
  const auto& records = passage.front()[pinion_body].records();
  const double margin = near_end * (line_.exit() - line_.entry());
  return !records.empty() && records.front().xi < line_.entry() + margin && records.back().xi > line_.exit() - margin;
}

std::vector<Passage> FlankRecorder::of_period(int mesh_periods) const {
  std::map<int, Passage> teeth;
  for (const auto& [number, passage] : passages_) {
    const int tooth = ((number % mesh_periods) + mesh_periods) % mesh_periods;
    Passage& whole = teeth[tooth];
    for (std::size_t row = 0; row < passage.size(); ++row) {
      for (std::size_t body = 0; body < body_count; ++body) {
        for (const SectionRecord& record : passage[row][body].records()) row_of(whole, row)[body].add(record);
      }
    }
  }
  std::vector<Passage> found;
  found.reserve(teeth.size());
  for (auto& [tooth, passage] : teeth) found.push_back(std::move(passage));
  return found;
}

}  // namespace gearfilm

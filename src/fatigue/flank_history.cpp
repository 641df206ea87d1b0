#include "fatigue/flank_history.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr std::array<std::size_t, stress_components> kept{0, 1, 2, 4, 3, 5};  // xx yy zz xz, yz xy
constexpr double round_off = 1e-9;                                            // of places, in steps

/// Whether a place in steps from the first one lies between first and last.
bool lies_within(const SectionPlaces& places, double place) {
  return place >= -round_off && place <= places.count - 1 + round_off;
}

}  // namespace

SectionRecord section_record(double xi, const SectionPlaces& places, const SectionStress& section, double stress_unit,
                             bool symmetric) {
  SectionRecord record{xi, places, symmetric ? 4 : static_cast<int>(stress_components), section.depths(), {}};
  record.values.reserve(static_cast<std::size_t>(record.components) * section.depths() * section.lines());
  for (int depth = 0; depth < section.depths(); ++depth) {
    for (int n = 0; n < record.components; ++n) {
      for (const double value : section.line_of(depth, kept[n])) {
        record.values.push_back(static_cast<float>(stress_unit * value));
      }
    }
  }
  return record;
}

Stress SectionRecord::at(int depth, double x) const {
  const double place = (x - places.first) / places.step;
  if (!lies_within(places, place)) return {};
  const int line = std::clamp(static_cast<int>(place), 0, std::max(0, places.count - 2)),
            next = std::min(line + 1, places.count - 1);
  const double t = place - line;
  std::array<double, stress_components> found{};
  for (int n = 0; n < components; ++n) {
    const float* value = values.data() + (static_cast<std::size_t>(depth) * components + n) * places.count;
    found[n] = (1.0 - t) * value[line] + t * value[next];
  }
  return {.xx = found[0], .yy = found[1], .zz = found[2], .yz = found[4], .xz = found[3], .xy = found[5]};
}

SectionRecord at_points(const SectionRecord& record, const FlankPath& path, std::span<const double> points) {
  std::vector<double> within;
  for (const double s : points) {
    const double x = path.place(s, record.xi);
    if (lies_within(record.places, (x - record.places.first) / record.places.step)) within.push_back(x);
  }
  if (static_cast<int>(within.size()) >= record.places.count) return record;
  std::ranges::sort(within);
  SectionRecord thinned{
      record.xi,
      {within.empty() ? 0.0 : within.front(), std::abs(points[1] - points[0]), static_cast<int>(within.size())},
      record.components,
      record.depths,
      {}};
  thinned.values.resize(within.size() * record.components * record.depths);
  for (int depth = 0; depth < record.depths; ++depth) {
    for (std::size_t n = 0; n < within.size(); ++n) {
      const std::array<double, stress_components> found = record.at(depth, within[n]).components();
      for (int c = 0; c < record.components; ++c) {
        thinned.values[(depth * record.components + c) * within.size() + n] = static_cast<float>(found[kept[c]]);
      }
    }
  }
  return thinned;
}

void FlankHistory::add(SectionRecord record) {
  const auto behind = std::ranges::upper_bound(records_, record.xi, {}, &SectionRecord::xi);
  records_.insert(behind, std::move(record));
}

PointHistory FlankHistory::at(double s, int depth) const {
  PointHistory history;
  for (const SectionRecord& record : records_) {
    const double x = path_.place(s, record.xi);
    if (!lies_within(record.places, (x - record.places.first) / record.places.step)) continue;
    if (!history.x.empty() && x <= history.x.back()) continue;
    history.x.push_back(x);
    history.stress.push_back(record.at(depth, x));
  }
  return history;
}

}  // namespace gearfilm

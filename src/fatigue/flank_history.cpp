#include "fatigue/flank_history.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr std::array<std::size_t, stress_components> kept{0, 1, 2, 4, 3, 5};  // xx yy zz xz, yz xy

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
  if (!(place >= 0.0) || place > places.count - 1) return {};
  const int line = std::min(static_cast<int>(place), places.count - 2);
  const double t = place - line;
  std::array<double, stress_components> found{};
  for (int n = 0; n < components; ++n) {
    const float* value = values.data() + (static_cast<std::size_t>(depth) * components + n) * places.count + line;
    found[n] = (1.0 - t) * value[0] + t * value[1];
  }
  return {.xx = found[0], .yy = found[1], .zz = found[2], .yz = found[4], .xz = found[3], .xy = found[5]};
}

void FlankHistory::add(SectionRecord record) {
  const auto behind = std::ranges::upper_bound(records_, record.xi, {}, &SectionRecord::xi);
  records_.insert(behind, std::move(record));
}

PointHistory FlankHistory::at(double s, int depth) const {
  PointHistory history;
  for (const SectionRecord& record : records_) {
    const double x = path_.place(s, record.xi),
                 end = record.places.first + record.places.step * (record.places.count - 1);
    if (x < record.places.first || x > end || (!history.x.empty() && x <= history.x.back())) continue;
    history.x.push_back(x);
    history.stress.push_back(record.at(depth, x));
  }
  return history;
}

}  // namespace gearfilm

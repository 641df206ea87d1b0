#include "contact/face.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace gearfilm {
namespace {

double relief_at(const EndRelief& relief, double from_end) {
  const double part = 1.0 - from_end / relief.length;
  return part > 0.0 ? relief.amount * std::pow(part, relief.power) : 0.0;
}

/// Linear between the points, constant beyond them.
double table_at(const std::vector<std::pair<double, double>>& points, double y) {
  if (y <= points.front().first) return points.front().second;
  if (y >= points.back().first) return points.back().second;
  const auto after = std::ranges::upper_bound(points, y, {}, &std::pair<double, double>::first), before = after - 1;
  return std::lerp(before->second, after->second, (y - before->first) / (after->first - before->first));
}

}  // namespace

double Face::operator()(double y) const {
  constexpr double cut_off = 1e-9;
  const double from_end = 0.5 * width - std::abs(y), relative = 2.0 * y / width;
  double sum = gap.slope * y;
  for (const EndRelief& relief : gap.reliefs) sum += relief_at(relief, from_end);
  if (gap.logarithmic != 0.0) sum -= gap.logarithmic * std::log(std::max(1.0 - relative * relative, cut_off));
  for (const auto& table : gap.tables) sum += table_at(table, y);
  return sum;
}

bool Face::symmetric() const { return gap.slope == 0.0 && gap.tables.empty(); }

std::vector<double> Face::kinks() const {
  std::set<double> places;
  const auto add = [&](double y) {
    if (std::abs(y) < 0.5 * width * (1.0 - 1e-9)) places.insert(y);
  };
  for (const EndRelief& relief : gap.reliefs) {
    if (relief.amount == 0.0) continue;
    add(0.5 * width - relief.length);
    add(relief.length - 0.5 * width);
  }
  for (const auto& table : gap.tables) {
    for (const auto& [y, value] : table) add(y);
  }
  return {places.begin(), places.end()};
}

bool Face::plain_around(double centre, double half_length) const {
  const double low = centre - half_length, high = centre + half_length;
  if (gap.logarithmic != 0.0 || low < -0.5 * width || high > 0.5 * width) return false;
  const bool relieved = std::ranges::any_of(gap.reliefs, [&](const EndRelief& relief) {
    const double middle = 0.5 * width - relief.length;
    return relief.amount != 0.0 && (low < -middle || high > middle);
  });
  return !relieved && gap.tables.empty();
}

}  // namespace gearfilm

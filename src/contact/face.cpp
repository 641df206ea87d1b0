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

bool is_within(const Face& face, double y) { return std::abs(y) < 0.5 * face.width * (1.0 - 1e-9); }

/// Where reliefs of a power begin, on both sides.
std::set<double> relieved_from(const Face& face, int power) {
  std::set<double> places;
  for (const EndRelief& relief : face.gap.reliefs) {
    const double begin = 0.5 * face.width - relief.length;
    if (relief.amount == 0.0 || relief.power != power || !is_within(face, begin)) continue;
    places.insert({-begin, begin});
  }
  return places;
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
  std::set<double> places = relieved_from(*this, 1);
  for (const auto& table : gap.tables) {
    for (const auto& [y, value] : table) {
      if (is_within(*this, y)) places.insert(y);
    }
  }
  return {places.begin(), places.end()};
}

std::vector<double> Face::bends() const {
  std::set<double> places = relieved_from(*this, 2);
  for (const double kink : kinks()) places.erase(kink);
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

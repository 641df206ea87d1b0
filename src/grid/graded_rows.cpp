#include "grid/graded_rows.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

struct Place {
  double y, step;
};

class Steps {
public:
  Steps(std::vector<Place> places, const RowGrading& grading) : places_(std::move(places)), grading_(grading) {}

  double operator()(double y) const {
    double step = grading_.largest;
    for (const Place& place : places_) {
      step = std::min(step, place.step + (grading_.growth - 1.0) * std::abs(y - place.y));
    }
    return step;
  }

private:
  std::vector<Place> places_;
  RowGrading grading_;
};

/// Rows behind `from` up to `to`, two places beside one another, by the midpoint rule for the integral of 1/h. h is
/// shortest at one of them.
void add_rows(const Steps& steps, double from, double to, std::vector<double>& rows) {
  constexpr double parts_in_step = 4.0;
  const double shortest = std::min(steps(from), steps(to));
  const int parts = std::max(4000, static_cast<int>(std::ceil(parts_in_step * (to - from) / shortest)));
  std::vector<double> passed(parts + 1, 0.0);
  const auto place = [&](double part) { return std::lerp(from, to, part / parts); };
  for (int n = 0; n < parts; ++n) passed[n + 1] = passed[n] + (to - from) / (parts * steps(place(n + 0.5)));
  const int count = std::max(1, static_cast<int>(std::ceil(passed.back() - 1e-6)));
  for (int row = 1; row < count; ++row) {
    const double wanted = passed.back() * row / count;
    const auto after = std::ranges::upper_bound(passed, wanted);
    const double before = *(after - 1);
    rows.push_back(place(static_cast<double>(after - passed.begin()) - 1.0 + (wanted - before) / (*after - before)));
  }
  rows.push_back(to);
}

}  // namespace

// Symmetric places make symmetric rows, to the bit: the lower half is the image of the upper one.
RowAxis graded_rows(double half_width, const std::vector<double>& kinks, const RowGrading& grading, Edge lower) {
  const auto upwards = [&](double sign) {
    std::vector<Place> places = {{-half_width, grading.first}, {half_width, grading.first}};
    for (const double y : kinks) places.push_back({sign * y, grading.kink});
    std::ranges::sort(places, {}, &Place::y);
    const Steps steps(places, grading);
    std::vector<double> rows = {0.0};
    for (const Place& place : places) {
      if (place.y > 0.0) add_rows(steps, rows.back(), place.y, rows);
    }
    return rows;
  };
  std::vector<double> rows = upwards(1.0);
  if (lower == Edge::symmetry) return {std::move(rows), lower, Edge::ambient};
  const std::vector<double> below = upwards(-1.0);
  std::vector<double> all;
  for (std::size_t n = below.size(); n-- > 1;) all.push_back(-below[n]);
  all.insert(all.end(), rows.begin(), rows.end());
  return {std::move(all), lower, Edge::ambient};
}

RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a) {
  std::vector<double> kinks = face.kinks();
  for (double& y : kinks) y /= a;
  return graded_rows(0.5 * face.width / a, kinks, grading, face.symmetric() ? Edge::symmetry : Edge::ambient);
}

}  // namespace gearfilm

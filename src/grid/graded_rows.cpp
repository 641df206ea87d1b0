#include "grid/graded_rows.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

class StepLaw {
public:
  StepLaw(std::vector<RowPlace> places, const RowGrading& grading)
      : places_(std::move(places)), growth_(grading.growth), largest_(grading.largest) {}

  double operator()(double y) const {
    double step = largest_;
    for (const RowPlace& place : places_) step = std::min(step, place.step + (growth_ - 1.0) * std::abs(y - place.y));
    return step;
  }
  double shortest() const { return std::ranges::min(places_, {}, &RowPlace::step).step; }

private:
  std::vector<RowPlace> places_;
  double growth_, largest_;
};

/// Rows behind `from` up to `to` by the midpoint rule for the integral of 1/h.
void add_rows(const StepLaw& steps, double from, double to, std::vector<double>& rows) {
  constexpr double parts_in_step = 4.0;
  const int parts = std::max(4000, static_cast<int>(std::ceil(parts_in_step * (to - from) / steps.shortest())));
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

void RowGrading::lengthen(double factor) {
  for (double* step : {&first, &kink, &bend, &largest}) *step *= factor;
  for (RowPlace& end : contact_ends) end.step *= factor;
}

// Symmetric places make symmetric rows, to the bit: the lower half is the image of the upper one.
RowAxis graded_rows(double half_width, const std::vector<RowPlace>& within, const RowGrading& grading, Edge lower) {
  const auto upwards = [&](double sign) {
    std::vector<RowPlace> rows_in = {{-half_width, grading.first}, {half_width, grading.first}};
    rows_in.insert(rows_in.end(), within.begin(), within.end());
    for (RowPlace& place : rows_in) {
      if (place.y < grading.reached.lower || place.y > grading.reached.upper) place.step = grading.largest;
    }
    std::vector<RowPlace> places = rows_in;
    places.insert(places.end(), grading.contact_ends.begin(), grading.contact_ends.end());
    for (std::vector<RowPlace>* all : {&rows_in, &places}) {
      for (RowPlace& place : *all) place.y *= sign;
    }
    std::ranges::sort(rows_in, {}, &RowPlace::y);
    const StepLaw steps(places, grading);
    std::vector<double> rows = {0.0};
    for (const RowPlace& place : rows_in) {
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

RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a, Edge lower) {
  std::vector<RowPlace> within;
  for (const double y : face.kinks()) within.push_back({y / a, grading.kink});
  for (const double y : face.bends()) within.push_back({y / a, grading.bend});
  return graded_rows(0.5 * face.width / a, within, grading, lower);
}

RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a) {
  return rows_over_face(face, grading, a, face.symmetric() ? Edge::symmetry : Edge::ambient);
}

}  // namespace gearfilm

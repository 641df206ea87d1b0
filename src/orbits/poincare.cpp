#include "orbits/poincare.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/tuned.hpp"
#include "orbits/affine_fit.hpp"

namespace gearfilm {
namespace {

constexpr int longest = 8;  // mesh periods
const Tuned<double> bends_beyond("recurrence_bends_beyond", 1.0, "distance from the last point beyond which maps bend");
const Tuned<double> noise("recurrence_noise", 3e-5, "noise of a march");
constexpr std::size_t spare = 2, most = 4;  // points that are fitted: beyond as many as unknowns, times those

double defect_of(const std::vector<PoincarePoint>& points, std::size_t period) {
  double largest = 0.0;
  for (std::size_t n = points.size() - period; n < points.size(); ++n) {
    largest = std::max(largest, length(difference(points[n].motion, points[n - period].motion)));
  }
  return largest;
}

/// Over so many mesh periods.
std::optional<Settling> settling_over(const std::vector<PoincarePoint>& points, std::size_t period) {
  if (points.size() <= period) return {};
  const Motion& last = points.back().motion;
  std::vector<Return> returns;
  for (std::size_t n = points.size() - 1; n >= period && returns.size() < most * AffineFit::unknowns(last);
       n -= period) {
    const Return one{difference(points[n - period].motion, last), difference(points[n].motion, last)};
    if (length(one.from) > bends_beyond) break;
    if (std::max(length(one.from), length(one.to)) > noise) returns.push_back(one);
  }
  if (returns.size() < AffineFit::unknowns(last) + spare) return {};
  const AffineFit fit(returns);
  const std::complex<double> larger = largest_multiplier(multipliers(fit.map()));
  const Motion rest = fit.fixed_point();
  // Not where the motions lie in a space of less dimensions than a map needs.
  if (!std::isfinite(std::abs(larger)) || !to_vector(rest).allFinite()) return {};
  return Settling{static_cast<int>(period), larger, 2.0 * fit.deviation(larger), moved(last, 1.0, rest)};
}

}  // namespace

void PoincareSection::begin() {
  now_ = {};
  now_.smallest_force = now_.smallest_film = HUGE_VAL;
  begun_ = true;
}

void PoincareSection::add(const StepRecord& record) {
  if (!begun_) begin();
  const std::vector<int> before = std::exchange(present_, {});
  for (const ContactRecord& contact : record.contacts) {
    present_.push_back(contact.number);
    now_.largest_force = std::max(now_.largest_force, contact.quantities["force"]);
    now_.smallest_film = std::min(now_.smallest_film, contact.quantities["h_min"]);
  }
  now_.smallest_force = std::min(now_.smallest_force, record.pressure_integral());
  const bool left = std::ranges::any_of(before, [&](int number) { return std::ranges::count(present_, number) == 0; });
  if (!left) return;
  now_.T = record.T;
  now_.motion = record.motion;
  points_.push_back(now_);
  begin();
}

std::optional<Recurrence> recurrence_of(const std::vector<PoincarePoint>& points, double tolerance) {
  if (points.size() < 2) return {};
  for (std::size_t period = 1; period <= longest && 2 * period <= points.size(); ++period) {
    const double defect = defect_of(points, period);
    if (defect >= tolerance) continue;
    // A swing that dies away comes near itself after some periods, and repeats in the end after fewer.
    for (std::size_t shorter = 1; shorter < period; ++shorter) {
      if (period % shorter != 0) continue;
      const auto settling = settling_over(points, shorter);
      if (settling && settling->contracts()) return Recurrence{0, defect_of(points, 1)};
    }
    return Recurrence{static_cast<int>(period), defect};
  }
  return Recurrence{0, defect_of(points, 1)};
}

std::optional<Settling> settling_of(const std::vector<PoincarePoint>& points, const Recurrence& recurrence) {
  if (recurrence.period > 0) return settling_over(points, static_cast<std::size_t>(recurrence.period));
  for (std::size_t period = 1; period <= longest; ++period) {
    auto settling = settling_over(points, period);
    if (settling && settling->contracts()) return settling;
  }
  return settling_over(points, 1);
}

}  // namespace gearfilm

#include "gearfilm/orbits/poincare.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearfilm/orbits/affine_fit.hpp"

namespace gearfilm {
namespace {

constexpr int longest = 8;                    // mesh periods
constexpr double far = 1.0;                   // in (H_0, V_0) from the last point: beyond it maps bend
constexpr double noise = 3e-5;                // of a march
constexpr std::size_t fewest = 5, most = 12;  // points that are fitted

double defect_of(const std::vector<PoincarePoint>& points, std::size_t period) {
  double largest = 0.0;
  for (std::size_t n = points.size() - period; n < points.size(); ++n) {
    largest = std::max(largest, length(difference(points[n].motion, points[n - period].motion)));
  }
  return largest;
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
    now_.largest_force = std::max(now_.largest_force, contact.figures["force"]);
    now_.smallest_film = std::min(now_.smallest_film, contact.figures["h_min"]);
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
    if (defect < tolerance) return Recurrence{static_cast<int>(period), defect};
  }
  return Recurrence{0, defect_of(points, 1)};
}

std::optional<Settling> settling_of(const std::vector<PoincarePoint>& points, const Recurrence& recurrence) {
  const std::size_t period = std::max(recurrence.period, 1);
  if (points.size() <= period) return {};
  std::vector<Return> returns;
  // Of each phase of the motion the last point stands for where it settles.
  for (std::size_t n = points.size() - period; n-- > 0;) {
    const std::size_t phase = points.size() - 1 - (points.size() - 1 - n) % period;
    const Motion& settled = points[phase].motion;
    const Return one{difference(points[n].motion, settled), difference(points[n + period].motion, settled)};
    if (length(one.from) > far || returns.size() == most) break;
    if (length(one.from) > noise && phase == points.size() - 1) returns.push_back(one);
  }
  if (returns.size() < fewest) return {};
  const AffineFit fit(returns);
  const auto mu = multipliers(fit.map());
  const std::complex<double> larger = std::abs(mu[0]) >= std::abs(mu[1]) ? mu[0] : mu[1];
  return Settling{static_cast<int>(period), larger, 2.0 * fit.deviation(larger)};
}

}  // namespace gearfilm

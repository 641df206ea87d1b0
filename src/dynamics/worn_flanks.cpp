#include "dynamics/worn_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gearfilm {

WornPair::WornPair(const std::array<FlankPlaces, 2>& places, double speed_ratio, double roughness,
                   const std::optional<RunningIn>& running_in)
    : places_(places),
      speed_ratio_(speed_ratio),
      first_roughness_(roughness),
      running_in_(running_in),
      flank_area_((places[0].end - places[0].begin) * 2.0 * places[0].half_width) {
  for (std::size_t gear = 0; gear < volumes_.size(); ++gear)
    volumes_[gear].assign(static_cast<std::size_t>(places[gear].along) * static_cast<std::size_t>(places[gear].across),
                          0.0);
}

double WornPair::roughness() const {
  if (!running_in_) return first_roughness_;
  const double left = std::exp(-work_ / running_in_->work);
  return running_in_->final_roughness + (first_roughness_ - running_in_->final_roughness) * left;
}

double WornPair::depth(std::size_t gear, int k, int j) const {
  const FlankPlaces& places = places_[gear];
  const std::size_t place = static_cast<std::size_t>(k) * static_cast<std::size_t>(places.across);
  return volumes_[gear][place + static_cast<std::size_t>(j)] / places.area(k, j);
}

double WornPair::largest_depth(std::size_t gear, const FlankVolumes& volumes) const {
  const FlankPlaces& places = places_[gear];
  double largest = 0.0;
  std::size_t n = 0;
  for (int k = 0; k < places.along; ++k) {
    for (int j = 0; j < places.across; ++j, ++n) largest = std::max(largest, volumes[n] / places.area(k, j));
  }
  return largest;
}

double WornPair::largest_depth(std::size_t gear) const { return largest_depth(gear, volumes_[gear]); }

double WornPair::volume(std::size_t gear) const {
  return std::accumulate(volumes_[gear].begin(), volumes_[gear].end(), 0.0);
}

double WornPair::revolutions_to(const PeriodWear& period, double depth) const {
  constexpr double most_change = 0.1;  // of the roughness
  double revolutions = HUGE_VAL;
  for (std::size_t gear = 0; gear < volumes_.size(); ++gear) {
    const double a_revolution = passages(gear, 1.0) * largest_depth(gear, period.volumes[gear]);
    if (a_revolution > 0.0) revolutions = std::min(revolutions, depth / a_revolution);
  }
  if (!running_in_ || !(period.work > 0.0)) return revolutions;
  const double left = roughness() - running_in_->final_roughness, change = most_change * roughness();
  if (left <= change) return revolutions;
  const double work = -running_in_->work * std::log(1.0 - change / left);
  return std::min(revolutions, work * flank_area_ / period.work);
}

void WornPair::wear(const PeriodWear& period, double revolutions) {
  for (std::size_t gear = 0; gear < volumes_.size(); ++gear) {
    for (std::size_t n = 0; n < volumes_[gear].size(); ++n)
      volumes_[gear][n] += passages(gear, revolutions) * period.volumes[gear][n];
  }
  work_ += revolutions * period.work / flank_area_;
  revolutions_ += revolutions;
}

FlankCurve WornPair::profile(std::size_t gear, double base_radius, int j) const {
  const FlankPlaces& places = places_[gear];
  FlankCurve curve;
  for (int k = 0; k < places.along; ++k)
    curve.emplace_back(std::sqrt(2.0 * base_radius * places.s(k)), depth(gear, k, j));
  return curve;
}

}  // namespace gearfilm

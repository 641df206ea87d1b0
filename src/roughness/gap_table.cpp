#include "roughness/gap_table.hpp"

#include <cmath>

namespace gearfilm {

GapTable::GapTable(const std::function<GapValues(double)>& of, bool isotropic) : isotropic_(isotropic) {
  const int count = static_cast<int>(std::lround((last - first) / step)) + 1;
  for (int k = 0; k < count; ++k) {
    const GapValues at = of(first + k * step);
    points_.push_back({{std::log(at.pressure), at.mean.value, std::log(at.along.value), std::log(at.across.value)},
                       {step * at.pressure_slope / at.pressure, step * at.mean.slope,
                        step * at.along.slope / at.along.value, step * at.across.slope / at.across.value}});
  }
}

GapValues GapTable::operator()(double z) const {
  const double place = (z - first) * (1.0 / step);
  const auto k = static_cast<std::size_t>(place);
  const Point &a = points_[k], &b = points_[k + 1];
  const double t = place - static_cast<double>(k), rest = 1.0 - t;
  const double to_b = t * t * (3.0 - 2.0 * t), by_a = t * rest * rest, by_b = -t * t * rest;
  const double slope_b = 6.0 * t * rest, slope_by_a = rest * (1.0 - 3.0 * t), slope_by_b = t * (3.0 * t - 2.0);
  const auto interpolated = [&](Function f) -> GapFunction {
    const double rise = b.value[f] - a.value[f];
    return {a.value[f] + to_b * rise + by_a * a.rise[f] + by_b * b.rise[f],
            (slope_b * rise + slope_by_a * a.rise[f] + slope_by_b * b.rise[f]) * (1.0 / step)};
  };
  const auto exponential = [](const GapFunction& logarithm) -> GapFunction {
    const double value = std::exp(logarithm.value);
    return {value, value * logarithm.slope};
  };
  const GapFunction pressure = exponential(interpolated(log_pressure)), along = exponential(interpolated(log_along));
  return {pressure.value, pressure.slope, interpolated(mean_gap), along,
          isotropic_ ? along : exponential(interpolated(log_across))};
}

}  // namespace gearfilm

#include "roughness/gap_table.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

/// Weights of cubic Hermite interpolation between two points, by values and by slopes times their distance.
struct Cubic {
  explicit Cubic(double t)
      : to_b(t * t * (3.0 - 2.0 * t)),
        by_a(t * (1.0 - t) * (1.0 - t)),
        by_b(-t * t * (1.0 - t)),
        slope_b(6.0 * t * (1.0 - t)),
        slope_by_a((1.0 - t) * (1.0 - 3.0 * t)),
        slope_by_b(t * (3.0 * t - 2.0)) {}

  /// The value, and its slope in t.
  GapFunction operator()(double a, double b, double rise_a, double rise_b) const {
    return {a + to_b * (b - a) + by_a * rise_a + by_b * rise_b,
            slope_b * (b - a) + slope_by_a * rise_a + slope_by_b * rise_b};
  }

  double to_b, by_a, by_b, slope_b, slope_by_a, slope_by_b;
};

GapFunction exponential(const GapFunction& logarithm) {
  const double value = std::exp(logarithm.value);
  return {value, value * logarithm.slope};
}

}  // namespace

GapTable::GapTable(const std::function<GapValues(double)>& of, bool isotropic, bool has_shear)
    : isotropic_(isotropic), has_shear_(has_shear) {
  const int count = static_cast<int>(std::lround((last - first) / step)) + 1;
  for (int k = 0; k < count; ++k) {
    const GapValues at = of(first + k * step);
    points_.push_back(
        {{std::log(at.pressure), at.mean.value, std::log(at.along.value), std::log(at.across.value), at.shear.value},
         {step * at.pressure_slope / at.pressure, step * at.mean.slope, step * at.along.slope / at.along.value,
          step * at.across.slope / at.across.value, step * at.shear.slope}});
  }
  first_far_ = static_cast<std::uint32_t>(points_.size());
  points_.push_back({{0.0, 0.0, 1.0, 1.0, 0.0}, {}});
  for (int k = 1; k <= far_steps; ++k) {
    const double z = last * far_steps / k;
    const GapValues at = of(z);
    const auto of_z = [&](const GapFunction& g) { return (g.value - g.slope * z) / (last * far_steps); };
    points_.push_back({{0.0, 0.0, at.along.value / z, at.across.value / z, at.shear.value},
                       {0.0, 0.0, of_z(at.along), of_z(at.across), -at.shear.slope * z * z / (last * far_steps)}});
  }
}

GapValues GapTable::operator()(double z) const {
  const double place = (z - first) * (1.0 / step);
  const auto k = static_cast<std::size_t>(place);
  const Point &a = points_[k], &b = points_[k + 1];
  const Cubic at(place - static_cast<double>(k));
  const auto interpolated = [&](Function f) -> GapFunction {
    const GapFunction by_place = at(a.value[f], b.value[f], a.rise[f], b.rise[f]);
    return {by_place.value, by_place.slope * (1.0 / step)};
  };
  const GapFunction pressure = exponential(interpolated(log_pressure)), along = exponential(interpolated(log_along));
  return {pressure.value,
          pressure.slope,
          interpolated(mean_gap),
          along,
          isotropic_ ? along : exponential(interpolated(log_across)),
          has_shear_ ? interpolated(shear_flow) : GapFunction{0.0, 0.0}};
}

GapValues GapTable::far(double z) const {
  const double inverse = 1.0 / z, place = last * far_steps * inverse;
  const std::size_t k = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(far_steps - 1));
  const Point &a = points_[first_far_ + k], &b = points_[first_far_ + k + 1];
  const Cubic at(place - static_cast<double>(k));
  // By the place, which changes by -place/z.
  const auto interpolated = [&](Function f) -> GapFunction { return at(a.value[f], b.value[f], a.rise[f], b.rise[f]); };
  const auto times_z = [&](Function f) -> GapFunction {
    const GapFunction part = interpolated(f);
    return {z * part.value, part.value - place * part.slope};
  };
  const GapFunction along = times_z(log_along);
  GapFunction shear{0.0, 0.0};
  if (has_shear_) shear = interpolated(shear_flow);
  return {0.0,
          0.0,
          {z, 1.0},
          along,
          isotropic_ ? along : times_z(log_across),
          {shear.value, -place * inverse * shear.slope}};
}

}  // namespace gearfilm

#include "gearfilm/dynamics/dry_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

double force_at_unit_approach(const Scales& scales, double relative_radius) {
  const double load = hertz_load(solids_of(scales, {.relative_radius = relative_radius}), scales.thickness);
  return load / scales.operation.load * scales.static_force;
}

}  // namespace

DryForce::DryForce(const MeshModel& mesh) {
  // R_x is a parabola over the path, largest midway between the base circles: its ends have the smallest.
  const LineOfAction& line = mesh.path.line();
  const double from_pinion = line.radius_pinion(0.0), from_wheel = line.radius_wheel(0.0);
  const double top = std::clamp(0.5 * (from_wheel - from_pinion), line.entry(), line.exit());
  const double reference = mesh.scales.solids.radius_x;
  const double low = std::log(std::min(line.radius_x(line.entry()), line.radius_x(line.exit())) / reference);
  const double high = std::log(line.radius_x(top) / reference);
  middle_ = 0.5 * (low + high);
  half_range_ = std::max(0.5 * (high - low), 1e-3);
  std::array<double, terms> values{};
  const auto angle = [](int node) { return std::numbers::pi * (node + 0.5) / terms; };
  for (int node = 0; node < terms; ++node) {
    values[node] =
        std::log(force_at_unit_approach(mesh.scales, std::exp(middle_ + half_range_ * std::cos(angle(node)))));
  }
  for (int k = 0; k < terms; ++k) {
    for (int node = 0; node < terms; ++node) {
      coefficients_[k] += (k == 0 ? 1.0 : 2.0) / terms * values[node] * std::cos(k * angle(node));
    }
  }
}

// Clenshaw's recurrence.
double DryForce::operator()(const ContactConditions& conditions, double H0) const {
  const double approach = -(H0 + conditions.gap_offset);
  if (approach <= 0.0) return 0.0;
  const double x = (std::log(conditions.relative_radius) - middle_) / half_range_;
  double after = 0.0, here = 0.0;
  for (int k = terms - 1; k > 0; --k) {
    const double before = coefficients_[k] + 2.0 * x * here - after;
    after = here;
    here = before;
  }
  return std::exp(coefficients_[0] + x * here - after) * approach * std::sqrt(approach);
}

}  // namespace gearfilm

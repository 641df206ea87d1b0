#include "roughness/topography.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gearfilm {
namespace {

SurfaceHeight height_of(const Waviness& wave, double at) {
  const double number = 2.0 * std::numbers::pi / wave.wavelength, angle = number * at + wave.phase;
  return {wave.amplitude * std::cos(angle), -wave.amplitude * number * std::sin(angle)};
}

}  // namespace

Topography::Topography(std::optional<Waviness> along, std::optional<Waviness> across, const HeightProfile& profile,
                       double remaining)
    : along_(along), across_(across), begin_(profile.begin), step_(profile.step), remaining_(remaining) {
  const std::vector<double>& z = profile.heights;
  const auto height = [&](std::ptrdiff_t k) {
    return k < 0 || k >= static_cast<std::ptrdiff_t>(z.size()) ? 0.0 : z[static_cast<std::size_t>(k)];
  };
  if (z.empty()) return;
  for (std::ptrdiff_t k = -1; k <= static_cast<std::ptrdiff_t>(z.size()); ++k)
    coefficients_.push_back(height(k) - (height(k - 1) - 2.0 * height(k) + height(k + 1)) / 6.0);
}

SurfaceHeight Topography::along(double s) const {
  SurfaceHeight result;
  if (along_) result = height_of(*along_, s);
  if (coefficients_.empty()) return result;
  const double place = (s - begin_) / step_, cell = std::floor(place), t = place - cell;
  const double u = 1.0 - t;
  const std::array<double, 4> weights = {u * u * u / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
                                         (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0, t * t * t / 6.0};
  const std::array<double, 4> slopes = {-0.5 * u * u, t * (1.5 * t - 2.0), u * (2.0 - 1.5 * u), 0.5 * t * t};
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const double k = cell + static_cast<double>(n);  // of the coefficient, counted from that before the first height
    if (k < 0.0 || k >= static_cast<double>(coefficients_.size())) continue;
    const double coefficient = coefficients_[static_cast<std::size_t>(k)];
    result.value += weights[n] * coefficient;
    result.slope += slopes[n] * coefficient / step_;
  }
  return result;
}

SurfaceHeight Topography::across(double y) const { return across_ ? height_of(*across_, y) : SurfaceHeight{}; }

}  // namespace gearfilm

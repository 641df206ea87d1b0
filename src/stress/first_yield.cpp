#include "stress/first_yield.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gearfilm {

double first_yield_ratio(double axes) {
  // Largest von Mises stress in p_h at axes 0, 0.2, ... 1 (patches of load below Hertz pressures).
  constexpr std::array largest = {0.5575, 0.5861, 0.6050, 0.6147, 0.6189, 0.6200};
  const double place = std::clamp(axes, 0.0, 1.0) * (largest.size() - 1.0);
  const std::size_t below = std::min(static_cast<std::size_t>(place), largest.size() - 2);
  return 1.0 / std::lerp(largest[below], largest[below + 1], place - static_cast<double>(below));
}

}  // namespace gearfilm

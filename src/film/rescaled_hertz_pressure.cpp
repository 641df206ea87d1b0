#include "film/rescaled_hertz_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double narrowest = 0.05;  // q of a line whose pressure tells what it would be on a wider one
constexpr double unloaded = 0.1;    // of the pressure that a line keeps when it is loaded no longer

}  // namespace

std::vector<double> rescaled_hertz_pressure(const Grid& grid, const Scales& scales, const HertzContact& before,
                                            double ratio, std::span<const double> pressure, double centre) {
  const int rows = grid.y_count();
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i) * rows + j; };
  const double a = before.a / scales.length, b = before.b / scales.length, top = before.pressure / scales.pressure;
  std::vector<double> after(pressure.begin(), pressure.end());
  for (int j = 0; j < rows; ++j) {
    const double y = grid.y(j) / b;
    const double width = 1.0 - y * y, new_width = ratio * ratio - y * y;  // q, and after
    const double s = std::sqrt(std::max(0.0, new_width / width));
    for (int i = 1; i < grid.nx() - 1; ++i) {
      double& value = after[at(i, j)];
      const double x = (grid.x(i) - centre) / a;
      if (width > narrowest && new_width <= 0.0) {
        value *= unloaded;
      } else if (width > narrowest) {
        const double place =
            std::clamp((centre + (grid.x(i) - centre) / s - grid.x(0)) / grid.h_x(), 0.0, grid.nx() - 1.001);
        const int n = static_cast<int>(place);
        value = s * ((n + 1 - place) * pressure[at(n, j)] + (place - n) * pressure[at(n + 1, j)]);
      } else if (x * x < new_width) {
        value = top * std::sqrt(new_width - x * x);
      }
    }
  }
  return after;
}

}  // namespace gearfilm

#include "film/carried_heights.hpp"

#include <algorithm>

#include "contact/line_contact.hpp"

namespace gearfilm {

CarriedHeights carried_heights(const Grid& grid, const Scales& scales, const ContactConditions& conditions) {
  const ContactTexture& texture = conditions.texture;
  CarriedHeights result;
  if (!texture.travels()) return result;
  const double U = conditions.entrainment, u_1 = U + 0.5 * conditions.sliding, u_2 = U - 0.5 * conditions.sliding;
  const double across = has_ellipse(scales.solids) ? scales.hertz.ellipticity : 0.0, slope_unit = scales.length;
  for (int i = 0; i < grid.nx(); ++i) {
    const double X = grid.x(i);
    const auto [pinion, wheel] = texture.along(X * scales.length);
    const double w_1 = (*texture.flanks)[0].remaining() / scales.thickness,
                 w_2 = (*texture.flanks)[1].remaining() / scales.thickness;
    const double t = w_1 * pinion.value + w_2 * wheel.value;
    const double pinion_slope = slope_unit * w_1 * pinion.slope, wheel_slope = slope_unit * w_2 * wheel.slope;
    const double passed = texture.moves ? u_1 * pinion_slope + u_2 * wheel_slope : 0.0;
    const double carried = U * (pinion_slope + wheel_slope) - passed;
    for (int j = 0; j < grid.y_count(); ++j) {
      const double Y = across * grid.y(j), P = std::max(0.0, 1.0 - X * X - Y * Y);
      const PressureFunction rho = relative_density(scales.oil, P * scales.pressure);
      const double rho_X = P > 0.0 ? -2.0 * X * scales.pressure * rho.derivative : 0.0;
      result.mass.push_back(rho.value * t);
      result.transport.push_back(rho.value * carried + U * rho_X * t);
    }
  }
  return result;
}

}  // namespace gearfilm

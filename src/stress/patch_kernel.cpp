#include "stress/patch_kernel.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace gearfilm {
namespace {

/// What both loads have in common at a corner.
struct Corner {
  Corner(double x_, double y_, double z_) : x(x_), y(y_), z(z_), R(std::sqrt(x * x + y * y + z * z)) {
    Rx = x < 0.0 ? (y * y + z * z) / (R - x) : R + x;  // without cancellation
    Ry = y < 0.0 ? (x * x + z * z) / (R - y) : R + y;
    Rz = R + z;
    A = std::atan2(x * y, z * R);
  }

  double x, y, z, R, Rx, Ry, Rz, A;
};

Stress under_pressure(const Corner& c, double nu) {
  const double x = c.x, y = c.y, z = c.z, R = c.R;
  const double X2 = std::atan2(x * y * (R - z), x * x * R + y * y * z),
               Y2 = std::atan2(x * y * (R - z), y * y * R + x * x * z);
  return {.xx = -X2 - 2.0 * nu * Y2 - z * x / (R * c.Ry),
          .yy = -Y2 - 2.0 * nu * X2 - z * y / (R * c.Rx),
          .zz = -c.A + z * (x / (R * c.Ry) + y / (R * c.Rx)),
          .yz = -z * z / (R * c.Rx),
          .xz = -z * z / (R * c.Ry),
          .xy = -(1.0 - 2.0 * nu) * std::log(c.Rz) - z / R};
}

Stress under_shear(const Corner& c, double nu) {
  const double x = c.x, y = c.y, z = c.z, R = c.R;
  const double ln_Ry = std::log(c.Ry);
  return {.xx = 2.0 * ln_Ry + 2.0 * nu * y / c.Rz + z * (y / (R * c.Rz) + z / (R * c.Ry)),
          .yy = 2.0 * nu * (ln_Ry - y / c.Rz) - z * y / (R * c.Rz),
          .zz = -z * z / (R * c.Ry),
          .yz = -z / R,
          .xz = -c.A - z * x / (R * c.Ry),
          .xy = std::log(c.Rx) - 2.0 * nu * x / c.Rz - z * x / (R * c.Rz)};
}

}  // namespace

Stress patch_corner(SurfaceLoad load, double x, double y, double z, double nu) {
  constexpr double factor = 0.5 / std::numbers::pi;
  if (load == SurfaceLoad::pressure) return factor * under_pressure({x, y, z}, nu);
  if (load == SurfaceLoad::shear_x) return factor * under_shear({x, y, z}, nu);
  Stress turned = factor * under_shear({y, x, z}, nu);
  std::swap(turned.xx, turned.yy);
  std::swap(turned.xz, turned.yz);
  return turned;
}

Stress patch_stress(SurfaceLoad load, double x, double h_x, const Strip& strip, double z, double nu) {
  const double left = x - 0.5 * h_x, right = x + 0.5 * h_x;
  const auto corner = [&](double at_x, double at_y) { return patch_corner(load, at_x, at_y, z, nu); };
  return corner(right, -strip.lower) + -1.0 * corner(left, -strip.lower) + -1.0 * corner(right, -strip.upper) +
         corner(left, -strip.upper);
}

}  // namespace gearfilm

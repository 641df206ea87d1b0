#include "stress/equivalent_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

/// Second and third invariant of the deviator.
struct Invariants {
  double J2, J3;
};

Invariants invariants(const Stress& t) {
  const double p = hydrostatic(t), x = t.xx - p, y = t.yy - p, z = t.zz - p;
  return {0.5 * (x * x + y * y + z * z) + t.yz * t.yz + t.xz * t.xz + t.xy * t.xy,
          x * (y * z - t.yz * t.yz) - t.xy * (t.xy * z - t.yz * t.xz) + t.xz * (t.xy * t.yz - y * t.xz)};
}

double angle_of(const Invariants& of) {
  const double cosine = 1.5 * std::numbers::sqrt3 * of.J3 / (of.J2 * std::sqrt(of.J2));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) / 3.0;
}

}  // namespace

Stress& Stress::operator+=(const Stress& other) {
  xx += other.xx;
  yy += other.yy;
  zz += other.zz;
  yz += other.yz;
  xz += other.xz;
  xy += other.xy;
  return *this;
}

Stress operator+(Stress a, const Stress& b) { return a += b; }

Stress operator*(double factor, const Stress& t) {
  return {factor * t.xx, factor * t.yy, factor * t.zz, factor * t.yz, factor * t.xz, factor * t.xy};
}

double von_mises(const Stress& stress) { return std::sqrt(3.0 * invariants(stress).J2); }

double largest_shear_stress(const Stress& stress) {
  const Invariants of = invariants(stress);
  return of.J2 > 0.0 ? std::sqrt(of.J2) * std::sin(angle_of(of) + std::numbers::pi / 3.0) : 0.0;
}

double largest_principal(const Stress& stress) {
  const Invariants of = invariants(stress);
  const double deviation = of.J2 > 0.0 ? 2.0 * std::sqrt(of.J2 / 3.0) * std::cos(angle_of(of)) : 0.0;
  return hydrostatic(stress) + deviation;
}

}  // namespace gearfilm

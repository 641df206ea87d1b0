// A stress below a surface and what criteria of strength make of it.
//
// Tension is positive; z points into the body, x along the direction of rolling, y along the face. With the deviator
// s = sigma - p_H 1, p_H = tr sigma/3, J2 = s:s/2 and J3 = det s
//   theta = acos(3 sqrt(3) J3/(2 J2^1.5))/3 ,
//   largest principal stress  p_H + 2 sqrt(J2/3) cos theta ,   half the difference of the outer two
//   sqrt(J2) sin(theta + pi/3) ,   von Mises  sqrt(3 J2) .
#pragma once

#include <array>
#include <cstddef>

namespace gearfilm {

/// Components in the order xx yy zz yz xz xy.
constexpr std::size_t stress_components = 6;

struct Stress {
  double xx = 0.0, yy = 0.0, zz = 0.0, yz = 0.0, xz = 0.0, xy = 0.0;

  std::array<double, stress_components> components() const { return {xx, yy, zz, yz, xz, xy}; }
  Stress& operator+=(const Stress& other);
};

Stress operator+(Stress a, const Stress& b);
Stress operator*(double factor, const Stress& t);

/// p_H, a third of the trace.
inline double hydrostatic(const Stress& stress) { return (stress.xx + stress.yy + stress.zz) / 3.0; }
double von_mises(const Stress& stress);
/// Half the difference of the largest and the smallest principal stress.
double largest_shear_stress(const Stress& stress);
double largest_principal(const Stress& stress);

}  // namespace gearfilm

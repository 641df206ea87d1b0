#include "roughness/height_integrals.hpp"

#include <cmath>
#include <numbers>

namespace gearfilm {

// With s = u + x^2 the integrand 2 x^(2n+1) exp(-s^2/2) is even and smooth for n = 3/2 and 5/2, and the trapezoidal
// rule converges exponentially; for whole n it is of the order 2n + 2.
double height_integral(double n, double u) {
  constexpr int points = 2000;
  constexpr double negligible = 40.0;  // exponents below which nothing is left
  const double peak = u > 0.0 ? 0.5 * u * u : 0.0;
  const double reach = std::sqrt(2.0 * (negligible + peak)) - u;  // of s - u
  const double step = std::sqrt(reach) / points;
  double sum = 0.0;
  for (int k = 1; k <= points; ++k) {
    const double x = k * step, s = u + x * x;
    sum += 2.0 * std::pow(x, 2.0 * n + 1.0) * std::exp(peak - 0.5 * s * s);
  }
  return sum * step * std::exp(-peak) / std::sqrt(2.0 * std::numbers::pi);
}

}  // namespace gearfilm

#include "gearfilm/orbits/monodromy.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {

std::array<std::complex<double>, 2> multipliers(const Monodromy& monodromy) {
  const double half_trace = 0.5 * monodromy.trace();
  const std::complex<double> root = std::sqrt(std::complex<double>(half_trace * half_trace - monodromy.determinant()));
  return {half_trace + root, half_trace - root};
}

double largest_modulus(const std::array<std::complex<double>, 2>& mu) {
  return std::max(std::abs(mu[0]), std::abs(mu[1]));
}

std::optional<FreeOscillation> free_oscillation(const std::array<std::complex<double>, 2>& mu, double mesh_frequency,
                                                double natural_frequency) {
  if (mu[0].imag() == 0.0) return {};
  const double turn = std::abs(std::arg(mu[0])) / (2.0 * std::numbers::pi);
  const double ratio = natural_frequency / mesh_frequency;
  const double below = std::round(ratio + turn) - turn, above = std::round(ratio - turn) + turn;
  const double frequency = mesh_frequency * (std::abs(below - ratio) < std::abs(above - ratio) ? below : above);
  const double decay = -std::log(std::abs(mu[0])) * mesh_frequency;  // [1/s]
  const double angular = 2.0 * std::numbers::pi * frequency;
  return FreeOscillation{frequency, decay / std::hypot(decay, angular)};
}

}  // namespace gearfilm

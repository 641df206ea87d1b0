#include "orbits/monodromy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "algebra/dense.hpp"

namespace gearfilm {

Multipliers multipliers(const Monodromy& monodromy) {
  if (monodromy.rows() == 2) {
    const double half_trace = 0.5 * monodromy.trace();
    const std::complex<double> root = std::sqrt(std::complex<double>(half_trace * half_trace - determinant(monodromy)));
    return {half_trace + root, half_trace - root};
  }
  const Eigen::VectorXcd values = eigen_pairs(monodromy).values;
  Multipliers mu(values.begin(), values.end());
  std::ranges::sort(mu, [](const std::complex<double>& a, const std::complex<double>& b) {
    return std::pair(std::abs(a), a.imag()) > std::pair(std::abs(b), b.imag());
  });
  return mu;
}

std::complex<double> largest_multiplier(const Multipliers& mu) {
  return *std::ranges::max_element(mu, {}, [](const std::complex<double>& one) { return std::abs(one); });
}

std::optional<FreeOscillation> free_oscillation(const Multipliers& mu, double mesh_frequency,
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

#include "orbits/dry_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/dense.hpp"

namespace gearfilm {

std::array<RotationalMode, 2> dry_modes(double stiffness, const std::array<double, 2>& base_radii,
                                        const GearInertias& inertias) {
  const Eigen::Vector2d r(base_radii[0], -base_radii[1]);
  const Eigen::Matrix2d K = stiffness * r * r.transpose();
  const Eigen::Matrix2d M = Eigen::Vector2d(inertias.pinion, inertias.wheel).asDiagonal();
  const SymmetricEigenPairs eigen = symmetric_eigen_pairs(K, M);
  std::array<RotationalMode, 2> modes;
  for (int n = 0; n < 2; ++n) {
    const Eigen::Vector2d shape = eigen.vectors.col(n);
    Eigen::Index larger = 0;
    shape.cwiseAbs().maxCoeff(&larger);
    // The rigid mode's eigenvalue is zero but for round-off, of either sign.
    modes[n] = {std::sqrt(std::max(0.0, eigen.values[n])) / (2.0 * std::numbers::pi),
                {shape[0] / shape[larger], shape[1] / shape[larger]}};
  }
  return modes;
}

GearInertias disc_inertias(const std::array<double, 2>& base_radii, double mass) {
  const auto [r1, r2] = base_radii;
  const double factor = mass * (1.0 / (r1 * r1) + 1.0 / (r2 * r2));
  return {factor * std::pow(r1, 4), factor * std::pow(r2, 4)};
}

}  // namespace gearfilm

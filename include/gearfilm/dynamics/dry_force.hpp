// The force of a dry contact of a mesh (Hertz), at the cost of an interpolation.
//
//   F = k(R_x) (-H_0)^(3/2),   k the force at H_0 = -1
// ln k is a smooth function of ln R_x: a Chebyshev series has it to round-off over the radii of a path of contact.
#pragma once

#include <array>

#include "gearfilm/dynamics/mesh_model.hpp"

namespace gearfilm {

class DryForce {
public:
  explicit DryForce(const MeshModel& mesh);

  /// Pressure integral of one contact [-]; zero where the bodies are apart. Relative error below 1e-12.
  double operator()(const ContactConditions& conditions, double H0) const;

private:
  static constexpr int terms = 20;

  double middle_ = 0.0;      ///< of ln Rbar
  double half_range_ = 1.0;  ///< of ln Rbar
  std::array<double, terms> coefficients_{};
};

}  // namespace gearfilm

// The temperature of a surface that passes under a source of heat.
//
//   T(x) - T_b = 1/sqrt(pi k rho c u) Int_{-inf}^x q(x')/sqrt(x - x') dx'
// Carslaw and Jaeger's half-space, conduction into the depth alone: exact to 1 % where the Peclet number u a/(2 kappa)
// exceeds 100. Product integration with q linear between nodes, zero at the first:
//   Int = Sum_{m<=i} w_{i-m} q_m,  w_0 = 4/3 sqrt(h_x),  w_n = 4/3 sqrt(h_x) [(n+1)^1.5 - 2 n^1.5 + (n-1)^1.5]
#pragma once

#include <vector>

#include "traction/traction_model.hpp"

namespace gearfilm {

class MovingSource {
public:
  /// A source on lines of nodes h_x [m] apart.
  MovingSource(int lines, double h_x);

  /// w_0 [m^0.5]: of the heat at the place itself.
  double own_weight() const { return weights_.front(); }
  /// sums[j] = Sum_{m<i} w_{i-m} q_m[j] of lines of `rows` values each, one after the other in `heat` [W/m^1.5].
  void earlier(const std::vector<double>& heat, int i, std::vector<double>& sums) const;

private:
  std::vector<double> weights_;
};

/// 1/sqrt(pi k rho c u) of a body whose surface moves with u [m/s].
double surface_response(const HeatedBody& body, double velocity);

}  // namespace gearfilm

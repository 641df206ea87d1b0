// Risk of failure by rolling fatigue and what follows for life, relative to a reference.
//
//   I = Int ds Int dz (max(tau_a - tau_u, 0)/1 GPa)^c (z/a)^-h
// tau_a is half the range of the orthogonal shear stress at a point in one passage (Lundberg and Palmgren 1947), tau_u
// a threshold below which nothing fails (Ioannides and Harris 1985, doi 10.1115/1.3261081; both second-hand). From z =
// 0.05 a on: with friction the integrand has no limit at the surface. With Weibull's slope e
//   life over that of a reference = (I_reference/I)^(1/e) .
// In line contacts of the same radius I goes as p_h^9, in point contacts as p_h^10.
#pragma once

#include <span>

namespace gearfilm {

struct RiskOptions {
  double stress_exponent = 31.0 / 3.0;  ///< c
  double depth_exponent = 7.0 / 3.0;    ///< h
  double weibull_slope = 10.0 / 9.0;    ///< e
  double threshold = 0.0;               ///< tau_u, in the unit of amplitudes
};

/// Int dz/a of one point of the flank: amplitudes at increasing depths in a, from `from` on, by Simpson's rule on the
/// amplitude's cubic interpolation.
double risk_of_depths(std::span<const double> depths, std::span<const double> amplitudes, const RiskOptions& options,
                      double from = 0.05);

double life_ratio(double risk, double reference, const RiskOptions& options);

}  // namespace gearfilm

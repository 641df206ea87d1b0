// Oils by their free volume: Tait's equation of state, and the two correlations of viscosity by which high-pressure
// rheology is published.
//
//   Tait        V/V_R = [1 + a_v (T - T_R)] {1 - ln[1 + (1 + K') p/K]/(1 + K')},  K = K_R exp[-beta_K (T - T_R)]
//   Doolittle   ln eta = const + B R_0 w/(V/V_R - R_0 w),  w = 1 + eps_c (T - T_R)
//   Yasutomi    ln eta = const - 2.303 C_1 (T - T_g) F/[C_2 + (T - T_g) F],
//               T_g = T_g0 + A_1 ln(1 + A_2 p),  F = (1 + b_1 p)^b_2                  (the improved form)
// Tait and Doolittle as X. Liu, T. Long, X. Li, F. Guo, Frontiers in Manufacturing Technology 2 (2023) 1029860
// (doi 10.3389/fmtec.2022.1029860), eqs (19), (20), have them at one temperature, and with temperature as they are used
// since Bair's book on high-pressure rheology; Yasutomi's improved form likewise (book and papers not looked up).
// Pressures in [Pa], temperatures in [K]. Below p = 0 all are constant in p.
#pragma once

#include "gearfilm/lubricant/vector_math.hpp"

namespace gearfilm {

/// A function of pressure and temperature, with its derivatives.
struct StateFunction {
  double value, by_pressure, by_temperature;
};

struct TaitOil {
  double modulus = 0.0;    ///< K_R [Pa]
  double slope = 11.0;     ///< K'
  double softening = 0.0;  ///< beta_K [1/K]
  double expansion = 0.0;  ///< a_v [1/K]

  /// V/V_R; T over T_R.
  StateFunction volume(double pressure, double above) const {
    const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0, c = 1.0 + slope;
    const double K = modulus * exp(-softening * above), ratio = c * p / K;
    const double warm = 1.0 + expansion * above, pressed = 1.0 - log1p(ratio) / c;
    return {warm * pressed, -on * warm / (K * (1.0 + ratio)),
            expansion * pressed - warm * softening * ratio / ((1.0 + ratio) * c)};
  }
};

struct DoolittleOil {
  double factor = 0.0;     ///< B
  double occupied = 0.0;   ///< R_0, occupied volume over V_R
  double expansion = 0.0;  ///< eps_c [1/K]

  /// B R_0 w/(V/V_R - R_0 w). Where the free volume is nearly gone it goes on along its tangent.
  StateFunction log_viscosity(const StateFunction& volume, double above) const {
    const double w = 1.0 + expansion * above, free = volume.value - occupied * w, least = factor * occupied / most;
    const double kept = free > least ? free : least, inverse = 1.0 / kept;
    const double value = factor * occupied * w * (inverse + (kept - free) * inverse * inverse);
    const double slope = -factor * occupied * w * inverse * inverse;  // by the free volume
    return {value, slope * volume.by_pressure,
            slope * (volume.by_temperature - occupied * expansion) + expansion / w * value};
  }

private:
  static constexpr double most = 120.0;  // ln eta of a glass
};

struct YasutomiOil {
  double glass_temperature = 0.0;  ///< T_g0 [K]
  double A1 = 0.0;                 ///< [K]
  double A2 = 0.0;                 ///< [1/Pa]
  double b1 = 0.0;                 ///< [1/Pa]
  double b2 = 0.0;
  double C1 = 0.0;
  double C2 = 0.0;  ///< [K]

  /// -2.303 C_1 x/(C_2 + x). Deep in the glass it goes on along its tangent.
  StateFunction log_viscosity(double pressure, double temperature) const {
    const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0;
    const double F = exp(b2 * log1p(b1 * p)), above = temperature - glass_temperature - A1 * log1p(A2 * p);
    const double x = above * F, least = -0.5 * C2, kept = x > least ? x : least, sum = C2 + kept;
    const double slope = -2.303 * C1 * C2 / (sum * sum);
    return {-2.303 * C1 * kept / sum + slope * (x - kept),
            slope * on * F * (above * b2 * b1 / (1.0 + b1 * p) - A1 * A2 / (1.0 + A2 * p)), slope * F};
  }
};

}  // namespace gearfilm

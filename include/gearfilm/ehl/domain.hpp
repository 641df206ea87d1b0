// The rectangle on which the film of one contact is computed.
// Source: Table 1 of doi 10.1016/j.triboint.2013.01.017.
#pragma once

namespace gearfilm {

/// X from x_min to x_max in units of the Hertz half-axis a, |y| up to y_half in units of the half-axis b.
struct Domain {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_half = 0.0;
};

/// The paper's choice by the load group M: long for M < 200, short from there on.
constexpr Domain default_domain(double M) { return M < 200.0 ? Domain{-4.5, 1.5, 3.0} : Domain{-2.083, 1.25, 1.1}; }

}  // namespace gearfilm

// Integrals over Gaussian heights, which laws of asperities are made of.
//
//   F_n(u) = (2 pi)^(-1/2) Int_u^inf (s - u)^n exp(-s^2/2) ds ,   F_n' = -n F_(n-1)
// Their values agree with closed forms (parabolic cylinder functions).
#pragma once

namespace gearfilm {

/// F_n(u), n > 0, to ten digits.
double height_integral(double n, double u);

}  // namespace gearfilm

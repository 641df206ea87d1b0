// The slope of the polynomial through values at given times, T_0 first, at T_0: backward differences of any
// order at steps of any lengths.
//
//   p'(T_0) = sum_n a_n p(T_n) ,    a_0 = sum_(j>0) 1/(T_0 - T_j) ,
//   a_n = 1/(T_n - T_0) prod_(j>0, j/=n) (T_0 - T_j)/(T_n - T_j) .
//
// For p = exp(i w T), whose slope is i w p, these weights make D p of it: D = sum_n a_n exp(-i w (T_0 - T_n)).
#pragma once

#include <complex>
#include <vector>

namespace gearfilm {

/// a_n [1/T].
std::vector<double> slope_weights(const std::vector<double>& times);

/// D [1/T] at the circular frequency w [1/T].
std::complex<double> slope_of_oscillation(double w, const std::vector<double>& times);

}  // namespace gearfilm

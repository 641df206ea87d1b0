// How oil flows between rough surfaces, by the gap of their mean planes.
//
//   z = h/sigma, may be negative;  lay gamma = lambda_x/lambda_y, correlation lengths along the flow and across it
//   mean gap       h_T = sigma [z Phi(z) + phi(z)]  of Gaussian heights; phi, Phi: normal density and distribution
//   conductance    C(z) = phi_x(z) z^3 :  oil flows as through a smooth gap sigma C^(1/3), the conducting gap
//   pressure flow  phi_x = 1 - C e^(-r z), gamma <= 1;  1 + C z^(-r), gamma > 1;  phi_y(z, gamma) = phi_x(z, 1/gamma)
//   shear flow     phi_s = (Rq_1/sigma)^2 Phi_s(z, gamma_1) - (Rq_2/sigma)^2 Phi_s(z, gamma_2)
//                  Phi_s = A_1 z^a_1 exp(-a_2 z + a_3 z^2), z <= 5;  A_2 e^(-z/4) beyond
// Source: Patir and Cheng 1978 and 1979 (J. Lubrication Technology 100, 12-17; 101, 220-230). Assumptions: constants
// from memory, the papers were not read; C and r linear in ln gamma within a branch, phi_x itself between gamma = 1/3
// and 3; below the range of a factor, or where phi_x falls to 0.1, C goes on as an exponential, with its own slope; at
// z <= 0 Phi_s is zero.
#pragma once

#include <array>
#include <cmath>

namespace gearfilm {

/// A function of z with its slope.
struct GapFunction {
  double value, slope;
};

/// h_T/sigma.
GapFunction gaussian_mean_gap(double z);

/// C^(1/3) for one lay, 0.11 to 9.
class ConductingGap {
public:
  explicit ConductingGap(double lay);

  GapFunction operator()(double z) const;
  /// Where the exponential ends: z_0, C(z_0), and its exponent k.
  std::array<double, 3> continuation() const { return {first_, value_ * value_ * value_, 3.0 * exponent_}; }

private:
  /// A part of phi_x - 1.
  struct Term {
    double factor = 0.0, rate = 0.0;
    bool power = false;
  };
  GapFunction pressure_flow(double z) const;

  std::array<Term, 2> terms_{};
  double first_ = 0.0, value_ = 0.0, exponent_ = 0.0;  ///< z_0, C^(1/3) there, its relative slope
};

/// Phi_s for one lay, 0.11 to 9.
class ShearFlow {
public:
  explicit ShearFlow(double lay);

  GapFunction operator()(double z) const;

private:
  double A_1_ = 0.0, a_1_ = 0.0, a_2_ = 0.0, a_3_ = 0.0, A_2_ = 0.0;
};

}  // namespace gearfilm

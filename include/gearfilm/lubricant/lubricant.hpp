// Density and viscosity of the oil as functions of pressure, relative to ambient.
//
//   rho/rho_0 = (5.9e8 + 1.34 p)/(5.9e8 + p)                              Dowson and Higginson 1966
//   eta/eta_0 = exp{ (ln eta_0 + 9.67) [ (1 + p/p_0)^z - 1 ] }            Roelands 1966, p_0 = 1.96e8 Pa
//               z = alpha_B p_0/(ln eta_0 + 9.67)
//   eta/eta_0 = exp(alpha_B p)                                            Barus 1893
// Eqs (8), (9) of doi 10.1016/j.triboint.2013.01.017. Pressures in [Pa], eta_0 in [Pa s], alpha_B in [1/Pa].
// Below p = 0 (met only inside an iteration) both laws are continued as constants, with zero derivatives.
#pragma once

#include "gearfilm/lubricant/vector_math.hpp"

namespace gearfilm {

enum class ViscosityLaw { roelands, barus };
enum class DensityLaw { dowson_higginson, incompressible };

/// An isothermal piezoviscous compressible oil.
struct Lubricant {
  double viscosity = 0.0;           ///< ambient viscosity eta_0 [Pa s]
  double pressure_viscosity = 0.0;  ///< alpha_B [1/Pa]
  ViscosityLaw viscosity_law = ViscosityLaw::roelands;
  DensityLaw density_law = DensityLaw::dowson_higginson;
};

/// Throws InputError unless eta_0 and alpha_B are positive and, for Roelands, ln eta_0 + 9.67 > 0.
void check(const Lubricant& oil);

/// c = ln eta_0 + 9.67 of Roelands' law [-].
double roelands_span(const Lubricant& oil);
/// Its inverse; 0 with Barus' law.
inline double inverse_roelands_span(const Lubricant& oil) {
  return oil.viscosity_law == ViscosityLaw::roelands ? 1.0 / roelands_span(oil) : 0.0;
}
/// Roelands' exponent z [-].
double roelands_exponent(const Lubricant& oil);

/// A value and its derivative with respect to pressure [1/Pa].
struct PressureFunction {
  double value;
  double derivative;
};

/// The laws of one oil with their constants at hand, without branches: loops over them use vector instructions.
class OilLaws {
public:
  explicit OilLaws(const Lubricant& oil);

  PressureFunction density(double pressure) const {
    const double p = pressure > 0.0 ? pressure : 0.0, denominator = density_pressure_ + p;
    return {(density_pressure_ + density_limit_ * p) / denominator,
            positive(pressure) * density_slope_ / (denominator * denominator)};
  }

  template <ViscosityLaw law>
  PressureFunction log_viscosity(double pressure) const {
    const double p = pressure > 0.0 ? pressure : 0.0;
    if constexpr (law == ViscosityLaw::barus) return {alpha_ * p, positive(pressure) * alpha_};
    // expm1 and log1p keep the digits of the small pressures in the inlet, where the film is made.
    const double ratio = p * inverse_roelands_pressure_, growth = expm1(exponent_ * log1p(ratio));
    // d/dp = c z/p_0 (1+p/p_0)^(z-1), and c z/p_0 = alpha_B
    return {span_ * growth, positive(pressure) * alpha_ * (1.0 + growth) / (1.0 + ratio)};
  }

private:
  static double positive(double pressure) { return pressure < 0.0 ? 0.0 : 1.0; }

  double density_pressure_;
  double density_limit_;  ///< rho/rho_0 for p -> infinity
  double density_slope_;  ///< (limit - 1) A
  double alpha_;
  double inverse_roelands_pressure_;
  double span_ = 0.0;      ///< c
  double exponent_ = 0.0;  ///< z
};

PressureFunction relative_density(const Lubricant& oil, double pressure);
/// ln(eta/eta_0): kept as a logarithm because eta itself spans 20 decades in a loaded contact.
PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure);

}  // namespace gearfilm

// Density and viscosity of the oil as functions of pressure, relative to ambient.
//
//   rho/rho_0 = (5.9e8 + 1.34 p)/(5.9e8 + p)                              Dowson and Higginson 1966
//   eta/eta_0 = exp{ (ln eta_0 + 9.67) [ (1 + p/p_0)^z - 1 ] }            Roelands 1966, p_0 = 1.96e8 Pa
//               z = alpha_B p_0/(ln eta_0 + 9.67)
//   eta/eta_0 = exp(alpha_B p)                                            Barus 1893
// and those of free_volume.hpp. Eqs (8), (9) of doi 10.1016/j.triboint.2013.01.017. Pressures in [Pa], eta_0 in [Pa s],
// alpha_B in [1/Pa]. Below p = 0 (met only inside an iteration) both laws are continued as constants, with zero
// derivatives.
#pragma once

#include "gearfilm/lubricant/free_volume.hpp"

namespace gearfilm {

enum class ViscosityLaw { roelands, barus, doolittle, yasutomi };
enum class DensityLaw { dowson_higginson, incompressible, tait };

/// An isothermal piezoviscous compressible oil.
struct Lubricant {
  double viscosity = 0.0;           ///< ambient viscosity eta_0 [Pa s]
  double pressure_viscosity = 0.0;  ///< alpha_B [1/Pa]; of the laws of free_volume.hpp alpha* (isoviscous_coefficient)
  ViscosityLaw viscosity_law = ViscosityLaw::roelands;
  DensityLaw density_law = DensityLaw::dowson_higginson;
  double temperature = 363.15;            ///< T_0, at which all this holds [K]
  double reference_temperature = 363.15;  ///< T_R of what follows [K]
  TaitOil tait{};                         ///< with its density law or Doolittle's viscosity
  DoolittleOil doolittle{};
  YasutomiOil yasutomi{};
};

/// The viscosity follows pressure and temperature by free volume.
inline bool by_free_volume(const Lubricant& oil) {
  return oil.viscosity_law == ViscosityLaw::doolittle || oil.viscosity_law == ViscosityLaw::yasutomi;
}

/// Throws InputError unless eta_0 and alpha_B are positive, for Roelands, ln eta_0 + 9.67 > 0, and the constants of the
/// other laws leave the oil a liquid at T_0 and ambient pressure.
void check(const Lubricant& oil);

/// c = ln eta_0 + 9.67 of Roelands' law [-].
double roelands_span(const Lubricant& oil);
/// Its inverse, also where another law than Roelands' knows temperature and pressure together; 0 with Barus' law.
inline double inverse_roelands_span(const Lubricant& oil) {
  return oil.viscosity_law != ViscosityLaw::barus && roelands_span(oil) > 0.0 ? 1.0 / roelands_span(oil) : 0.0;
}
/// alpha* = 1/Int_0^inf eta_0/eta dp, the reciprocal asymptotic isoviscous pressure coefficient of the oil's law
/// [1/Pa].
double isoviscous_coefficient(const Lubricant& oil);
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

  template <DensityLaw law>
  PressureFunction density(double pressure) const {
    if constexpr (law == DensityLaw::tait) {
      const StateFunction volume = oil_.tait.volume(pressure, above_);
      const double rho = ambient_volume_ / volume.value;
      return {rho, -rho / volume.value * volume.by_pressure};
    }
    const double p = pressure > 0.0 ? pressure : 0.0, denominator = density_pressure_ + p;
    return {(density_pressure_ + density_limit_ * p) / denominator,
            positive(pressure) * density_slope_ / (denominator * denominator)};
  }

  template <ViscosityLaw law>
  PressureFunction log_viscosity(double pressure) const {
    const double p = pressure > 0.0 ? pressure : 0.0;
    if constexpr (law == ViscosityLaw::barus) return {alpha_ * p, positive(pressure) * alpha_};
    if constexpr (law == ViscosityLaw::doolittle || law == ViscosityLaw::yasutomi) {
      const StateFunction log_eta = log_viscosity_at<law>(pressure, oil_.temperature);
      return {log_eta.value, log_eta.by_pressure};
    }
    // expm1 and log1p keep the digits of the small pressures in the inlet, where the film is made.
    const double ratio = p * inverse_roelands_pressure_, growth = expm1(exponent_ * log1p(ratio));
    // d/dp = c z/p_0 (1+p/p_0)^(z-1), and c z/p_0 = alpha_B
    return {span_ * growth, positive(pressure) * alpha_ * (1.0 + growth) / (1.0 + ratio)};
  }

  /// Of the laws by free volume, at any temperature [K].
  template <ViscosityLaw law>
  StateFunction log_viscosity_at(double pressure, double temperature) const {
    const double above = temperature - oil_.reference_temperature;
    StateFunction log_eta = law == ViscosityLaw::yasutomi
                                ? oil_.yasutomi.log_viscosity(pressure, temperature)
                                : oil_.doolittle.log_viscosity(oil_.tait.volume(pressure, above), above);
    log_eta.value -= ambient_log_viscosity_;
    return log_eta;
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
  Lubricant oil_;
  double above_;                        ///< T_0 - T_R
  double ambient_volume_ = 1.0;         ///< V/V_R at T_0
  double ambient_log_viscosity_ = 0.0;  ///< without const of free_volume.hpp
};

/// Calls body, a function template of the viscosity law, with the law of the oil: so that loops need not ask.
template <class Body>
void with_viscosity_law(const Lubricant& oil, Body body) {
  switch (oil.viscosity_law) {
    case ViscosityLaw::roelands:
      return body.template operator()<ViscosityLaw::roelands>();
    case ViscosityLaw::barus:
      return body.template operator()<ViscosityLaw::barus>();
    case ViscosityLaw::doolittle:
      return body.template operator()<ViscosityLaw::doolittle>();
    case ViscosityLaw::yasutomi:
      return body.template operator()<ViscosityLaw::yasutomi>();
  }
}
/// The same of the density law; an incompressible oil has Dowson and Higginson's with other constants.
template <class Body>
void with_density_law(const Lubricant& oil, Body body) {
  if (oil.density_law == DensityLaw::tait) return body.template operator()<DensityLaw::tait>();
  body.template operator()<DensityLaw::dowson_higginson>();
}

PressureFunction relative_density(const Lubricant& oil, double pressure);
/// ln(eta/eta_0): kept as a logarithm because eta itself spans 20 decades in a loaded contact.
PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure);

}  // namespace gearfilm

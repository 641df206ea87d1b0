// Dowson-Higginson density, Roelands and Barus viscosity, eqs (8), (9) of doi 10.1016/j.triboint.2013.01.017:
//   rho/rho_0 = (A + 1.34 p)/(A + p),  A = 5.9e8 Pa
//   ln(eta/eta_0) = c [ (1 + p/p_0)^z - 1 ],  c = ln eta_0 + 9.67,  z = alpha_B p_0/c,  p_0 = 1.96e8 Pa
#include "gearfilm/lubricant/lubricant.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "gearfilm/error.hpp"

namespace gearfilm {

namespace {

constexpr double roelands_pressure = 1.96e8;  // p_0 [Pa]
constexpr double roelands_log = 9.67;         // -ln of the viscosity 6.315e-5 Pa s at which all oils meet
constexpr double density_pressure = 5.9e8;    // A [Pa]
constexpr double density_limit = 1.34;        // rho/rho_0 for p -> infinity

void require_positive(double value, const std::string& parameter, const std::string& unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  std::ostringstream message;
  message << parameter << " = " << value << " " << unit << " is not above zero: give the value at ambient pressure in "
          << unit;
  throw InputError(message.str());
}

}  // namespace

double roelands_span(const Lubricant& oil) { return std::log(oil.viscosity) + roelands_log; }

void check(const Lubricant& oil) {
  require_positive(oil.viscosity, "lubricant_viscosity", "Pa s");
  require_positive(oil.pressure_viscosity, "lubricant_pressure_viscosity", "1/Pa");
  if (oil.viscosity_law == ViscosityLaw::roelands && !(roelands_span(oil) > 0.0)) {
    std::ostringstream message;
    message << "lubricant_viscosity = " << oil.viscosity << " Pa s is not above " << std::exp(-roelands_log)
            << " Pa s, the lower limit of Roelands' law: give it in Pa s, or use the Barus law";
    throw InputError(message.str());
  }
}

double roelands_exponent(const Lubricant& oil) {
  return oil.pressure_viscosity * roelands_pressure / roelands_span(oil);
}

OilLaws::OilLaws(const Lubricant& oil)
    : density_pressure_(density_pressure),
      density_limit_(oil.density_law == DensityLaw::incompressible ? 1.0 : density_limit),
      density_slope_((density_limit_ - 1.0) * density_pressure),
      alpha_(oil.pressure_viscosity),
      inverse_roelands_pressure_(1.0 / roelands_pressure) {
  if (oil.viscosity_law == ViscosityLaw::barus) return;
  span_ = roelands_span(oil);
  exponent_ = roelands_exponent(oil);
}

PressureFunction relative_density(const Lubricant& oil, double pressure) { return OilLaws(oil).density(pressure); }

PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure) {
  const OilLaws laws(oil);
  return oil.viscosity_law == ViscosityLaw::barus ? laws.log_viscosity<ViscosityLaw::barus>(pressure)
                                                  : laws.log_viscosity<ViscosityLaw::roelands>(pressure);
}

}  // namespace gearfilm

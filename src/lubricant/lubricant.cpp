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

double log_viscosity_span(const Lubricant& oil) { return std::log(oil.viscosity) + roelands_log; }

void require_positive(double value, const std::string& parameter, const std::string& unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  std::ostringstream message;
  message << parameter << " = " << value << " " << unit << " is not above zero: give the value at ambient pressure in "
          << unit;
  throw InputError(message.str());
}

}  // namespace

void check(const Lubricant& oil) {
  require_positive(oil.viscosity, "lubricant_viscosity", "Pa s");
  require_positive(oil.pressure_viscosity, "lubricant_pressure_viscosity", "1/Pa");
  if (oil.viscosity_law == ViscosityLaw::roelands && !(log_viscosity_span(oil) > 0.0)) {
    std::ostringstream message;
    message << "lubricant_viscosity = " << oil.viscosity << " Pa s is not above " << std::exp(-roelands_log)
            << " Pa s, the lower limit of Roelands' law: give it in Pa s, or use the Barus law";
    throw InputError(message.str());
  }
}

double roelands_exponent(const Lubricant& oil) {
  return oil.pressure_viscosity * roelands_pressure / log_viscosity_span(oil);
}

PressureFunction relative_density(const Lubricant& oil, double pressure) {
  if (oil.density_law == DensityLaw::incompressible || pressure < 0.0) return {1.0, 0.0};
  const double denominator = density_pressure + pressure;
  return {(density_pressure + density_limit * pressure) / denominator,
          (density_limit - 1.0) * density_pressure / (denominator * denominator)};
}

PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure) {
  if (pressure < 0.0) return {0.0, 0.0};
  if (oil.viscosity_law == ViscosityLaw::barus) {
    return {oil.pressure_viscosity * pressure, oil.pressure_viscosity};
  }
  const double span = log_viscosity_span(oil);
  const double exponent = oil.pressure_viscosity * roelands_pressure / span;
  const double ratio = pressure / roelands_pressure;
  // expm1 and log1p keep the digits of the small pressures in the inlet, where the film is made.
  const double growth = std::expm1(exponent * std::log1p(ratio));
  // d/dp = c z/p_0 (1+p/p_0)^(z-1), and c z/p_0 = alpha_B
  return {span * growth, oil.pressure_viscosity * (1.0 + growth) / (1.0 + ratio)};
}

}  // namespace gearfilm

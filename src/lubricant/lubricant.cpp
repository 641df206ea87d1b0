// Density and viscosity of the oil: Dowson and Higginson, Roelands and Barus viscosity, eqs (8), (9) of
// doi 10.1016/j.triboint.2013.01.017:
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

namespace {

void check_doolittle(const Lubricant& oil) {
  const double above = oil.temperature - oil.reference_temperature;
  const double left =
      oil.tait.volume(0.0, above).value - oil.doolittle.occupied * (1.0 + oil.doolittle.expansion * above);
  if (left > 0.0) return;
  std::ostringstream message;
  message << "lubricant_doolittle_occupied = " << oil.doolittle.occupied << " leaves no free volume at "
          << oil.temperature << " K: give R_0 below 1, and temperatures in K";
  throw InputError(message.str());
}

void check_yasutomi(const Lubricant& oil) {
  if (oil.temperature > oil.yasutomi.glass_temperature) return;
  std::ostringstream message;
  message << "lubricant_yasutomi_glass_temperature = " << oil.yasutomi.glass_temperature
          << " K makes the oil a glass at thermal_temperature = " << oil.temperature << " K: give both in K";
  throw InputError(message.str());
}

}  // namespace

void check(const Lubricant& oil) {
  require_positive(oil.viscosity, "lubricant_viscosity", "Pa s");
  if (oil.viscosity_law == ViscosityLaw::doolittle) check_doolittle(oil);
  if (oil.viscosity_law == ViscosityLaw::yasutomi) check_yasutomi(oil);
  if (!by_free_volume(oil)) require_positive(oil.pressure_viscosity, "lubricant_pressure_viscosity", "1/Pa");
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
      inverse_roelands_pressure_(1.0 / roelands_pressure),
      oil_(oil),
      above_(oil.temperature - oil.reference_temperature) {
  if (oil.density_law == DensityLaw::tait) ambient_volume_ = oil.tait.volume(0.0, above_).value;
  if (oil.viscosity_law == ViscosityLaw::doolittle) {
    ambient_log_viscosity_ = log_viscosity_at<ViscosityLaw::doolittle>(0.0, oil.temperature).value;
  }
  if (oil.viscosity_law == ViscosityLaw::yasutomi) {
    ambient_log_viscosity_ = log_viscosity_at<ViscosityLaw::yasutomi>(0.0, oil.temperature).value;
  }
  if (oil.viscosity_law != ViscosityLaw::roelands) return;
  span_ = roelands_span(oil);
  exponent_ = roelands_exponent(oil);
}

PressureFunction relative_density(const Lubricant& oil, double pressure) {
  PressureFunction found{};
  with_density_law(oil, [&]<DensityLaw law>() { found = OilLaws(oil).density<law>(pressure); });
  return found;
}

PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure) {
  PressureFunction found{};
  with_viscosity_law(oil, [&]<ViscosityLaw law>() { found = OilLaws(oil).log_viscosity<law>(pressure); });
  return found;
}

// Simpson's rule in steps over which the viscosity hardly grows, until the rest is nothing.
double isoviscous_coefficient(const Lubricant& oil) {
  constexpr double step = 1e6, least = 1e-12;  // [Pa], of eta_0/eta
  const auto thinness = [&](double p) { return std::exp(-log_relative_viscosity(oil, p).value); };
  double sum = 0.0, begin = 1.0;
  for (double p = 0.0; begin > least && p < 1e4 * step; p += step) {
    const double end = thinness(p + step);
    sum += step / 6.0 * (begin + 4.0 * thinness(p + 0.5 * step) + end);
    begin = end;
  }
  return 1.0 / sum;
}

}  // namespace gearfilm

#include "lubricant/lubricant.hpp"

#include <cmath>
#include <sstream>

namespace gearfilm {
namespace {

/// Whether all alternatives of a variant are laws.
template <class Laws>
constexpr bool all_viscosity_laws = false;
template <ViscosityLaw... Law>
constexpr bool all_viscosity_laws<std::variant<Law...>> = true;
template <class Laws>
constexpr bool all_density_laws = false;
template <DensityLaw... Law>
constexpr bool all_density_laws<std::variant<Law...>> = true;
static_assert(all_viscosity_laws<AnyViscosityLaw> && all_density_laws<AnyDensityLaw>);

void require_positive(double value, const std::string& parameter, const std::string& unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(parameter + " = " + shown(value) + " " + unit +
                   " is not above zero: give the value at ambient pressure in " + unit);
}

AmbientOil ambient(const Lubricant& oil) {
  return {.viscosity = oil.viscosity, .pressure_viscosity = oil.pressure_viscosity, .temperature = oil.temperature};
}

}  // namespace

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

bool takes_coefficients(const Lubricant& oil) {
  return std::visit([]<class Law>(const Law&) { return Law::takes_coefficients; }, oil.viscosity_law);
}

void check(const Lubricant& oil) {
  require_positive(oil.viscosity, "lubricant_viscosity", "Pa s");
  if (takes_coefficients(oil)) require_positive(oil.pressure_viscosity, "lubricant_pressure_viscosity", "1/Pa");
  std::visit([&](const auto& law) { law.check(ambient(oil)); }, oil.viscosity_law);
}

ViscosityEvaluator viscosity_evaluator(const AnyViscosityLaw& law, const AmbientOil& oil) {
  return std::visit(
      [&]<class Law>(const Law& found) -> ViscosityEvaluator { return typename Law::Evaluator(found, oil); }, law);
}

ViscosityEvaluator viscosity_evaluator(const Lubricant& oil) {
  return viscosity_evaluator(oil.viscosity_law, ambient(oil));
}

DensityEvaluator density_evaluator(const Lubricant& oil) {
  return std::visit(
      [&]<class Law>(const Law& law) -> DensityEvaluator { return typename Law::Evaluator(law, oil.temperature); },
      oil.density_law);
}

PressureFunction relative_density(const Lubricant& oil, double pressure) {
  return std::visit([&](const auto& rho) { return rho.density(pressure); }, density_evaluator(oil));
}

PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure) {
  return std::visit([&](const auto& eta) { return eta.log_viscosity(pressure); }, viscosity_evaluator(oil));
}

// Simpson's rule in steps over which the viscosity hardly grows, until the rest is nothing.
double isoviscous_coefficient(const Lubricant& oil) {
  constexpr double step = 1e6, least = 1e-12;  // [Pa], of eta_0/eta
  const ViscosityEvaluator viscosity = viscosity_evaluator(oil);
  const auto thinness = [&](double p) {
    return std::exp(-std::visit([&](const auto& eta) { return eta.log_viscosity(p).value; }, viscosity));
  };
  double sum = 0.0, begin = 1.0;
  for (double p = 0.0; begin > least && p < 1e4 * step; p += step) {
    const double end = thinness(p + step);
    sum += step / 6.0 * (begin + 4.0 * thinness(p + 0.5 * step) + end);
    begin = end;
  }
  return 1.0 / sum;
}

}  // namespace gearfilm

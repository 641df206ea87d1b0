#include "input/case_lubricant.hpp"

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// A constant that a law needs.
double needed(const ParameterValues& values, const std::string& law, const std::string& key) {
  if (values.has(key)) return values.real(key);
  values.refuse(law, "is " + values.text(law) + ", but '" + key + "' is missing; give it, or another law");
}

/// One that follows from a law, and must not be given beside it.
void refuse(const ParameterValues& values, const std::string& law, const std::string& key) {
  if (!values.has(key)) return;
  values.refuse(key, "is given, but it follows from '" + law + "', which is " + values.text(law) + "; leave it out");
}

/// The law that the parameter names, with its constants.
template <class Laws>
Laws read_law(const ParameterValues& values, const std::string& parameter) {
  Laws found;
  each_law<Laws>([&]<class Law>() {
    if (Law::name != values.text(parameter)) return;
    Law law;
    law.each_constant([&](double& value, const OilConstant& constant) {
      const std::string key = "lubricant." + std::string(constant.name);
      const std::string_view* other = std::get_if<std::string_view>(&constant.standard);
      value = other && !values.has(key) ? values.real(std::string(*other)) : needed(values, parameter, key);
    });
    found = law;
  });
  return found;
}

/// Whether the law of density takes beta_rho.
bool takes_expansion(const Lubricant& oil) {
  return std::visit([]<class Law>(const Law&) { return Law::takes_expansion; }, oil.density_law);
}

}  // namespace

Lubricant read_lubricant(const ParameterValues& values) {
  const std::string viscosity = "lubricant.viscosity_law", density = "lubricant.density_law";
  const std::string alpha = "lubricant.pressure_viscosity", expansion = "lubricant.expansion";
  Lubricant oil{.viscosity = values.real("lubricant.viscosity"),
                .density_law = read_law<AnyDensityLaw>(values, density),
                .temperature = values.real("thermal.temperature")};
  if (!takes_expansion(oil) && values.real(expansion) != 0.0) refuse(values, density, expansion);
  oil.viscosity_law = read_law<AnyViscosityLaw>(values, viscosity);
  const bool given = takes_coefficients(oil);
  if (given) {
    oil.pressure_viscosity = needed(values, viscosity, alpha);
  } else {
    refuse(values, viscosity, alpha);
    refuse(values, viscosity, "lubricant.temperature_viscosity");
  }
  in_file_of(values, [&] { check(oil); });
  if (!given) oil.pressure_viscosity = isoviscous_coefficient(oil);
  return oil;
}

std::optional<ThermalOil> read_thermal_oil(const ParameterValues& values) {
  const std::string given = "lubricant.temperature_viscosity";
  const Lubricant oil = read_lubricant(values);
  const double measured = values.real_if_given(given).value_or(0.0);
  const double beta = takes_coefficients(oil) ? measured : temperature_viscosity(oil);
  if (!(beta > 0.0)) return {};
  return ThermalOil{.temperature = oil.temperature,
                    .temperature_viscosity = beta,
                    .conductivity = values.real("lubricant.conductivity"),
                    .conductivity_pressure_1 = values.real("lubricant.conductivity_pressure_1"),
                    .conductivity_pressure_2 = values.real("lubricant.conductivity_pressure_2"),
                    .density = values.real("lubricant.density"),
                    .heat_capacity = values.real("lubricant.heat_capacity"),
                    .expansion = values.real("lubricant.expansion")};
}

}  // namespace gearfilm

#include "gearfilm/input/case_lubricant.hpp"

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

ViscosityLaw viscosity_named(const std::string& name) {
  if (name == "barus") return ViscosityLaw::barus;
  if (name == "doolittle") return ViscosityLaw::doolittle;
  return name == "yasutomi" ? ViscosityLaw::yasutomi : ViscosityLaw::roelands;
}

DensityLaw density_named(const std::string& name) {
  if (name == "tait") return DensityLaw::tait;
  return name == "incompressible" ? DensityLaw::incompressible : DensityLaw::dowson_higginson;
}

/// A constant that a law needs.
double needed(const ParameterValues& values, const std::string& law, const std::string& key) {
  if (values.has(key)) return values.real(key);
  throw InputError(values.origin(law) + ": '" + law + "' is " + values.text(law) + ", but '" + key +
                   "' is missing; give it, or another law");
}

/// One that follows from a law, and must not be given beside it.
void refuse(const ParameterValues& values, const std::string& law, const std::string& key) {
  if (!values.has(key)) return;
  throw InputError(values.origin(key) + ": '" + key + "' is given, but it follows from '" + law + "', which is " +
                   values.text(law) + "; leave it out");
}

TaitOil read_tait(const ParameterValues& values, const std::string& law) {
  return {.modulus = needed(values, law, "lubricant.tait_modulus"),
          .slope = needed(values, law, "lubricant.tait_slope"),
          .softening = values.real("lubricant.tait_softening"),
          .expansion = values.real("lubricant.tait_expansion")};
}

DoolittleOil read_doolittle(const ParameterValues& values, const std::string& law) {
  return {.factor = needed(values, law, "lubricant.doolittle_factor"),
          .occupied = needed(values, law, "lubricant.doolittle_occupied"),
          .expansion = values.real("lubricant.doolittle_expansion")};
}

YasutomiOil read_yasutomi(const ParameterValues& values, const std::string& law) {
  const auto constant = [&](const std::string& name) { return needed(values, law, "lubricant.yasutomi_" + name); };
  return {.glass_temperature = constant("glass_temperature"),
          .A1 = constant("a1"),
          .A2 = constant("a2"),
          .b1 = constant("b1"),
          .b2 = constant("b2"),
          .C1 = constant("c1"),
          .C2 = constant("c2")};
}

}  // namespace

Lubricant read_lubricant(const ParameterValues& values) {
  const std::string viscosity = "lubricant.viscosity_law", density = "lubricant.density_law";
  const std::string alpha = "lubricant.pressure_viscosity", reference = "lubricant.reference_temperature";
  Lubricant oil{.viscosity = values.real("lubricant.viscosity"),
                .viscosity_law = viscosity_named(values.text(viscosity)),
                .density_law = density_named(values.text(density)),
                .temperature = values.real("thermal.temperature")};
  oil.reference_temperature = values.has(reference) ? values.real(reference) : oil.temperature;
  if (oil.density_law == DensityLaw::tait) {
    oil.tait = read_tait(values, density);
    if (values.real("lubricant.expansion") != 0.0) refuse(values, density, "lubricant.expansion");
  }
  if (oil.viscosity_law == ViscosityLaw::doolittle) {
    oil.tait = read_tait(values, viscosity);
    oil.doolittle = read_doolittle(values, viscosity);
  }
  if (oil.viscosity_law == ViscosityLaw::yasutomi) oil.yasutomi = read_yasutomi(values, viscosity);
  if (by_free_volume(oil)) {
    refuse(values, viscosity, alpha);
    refuse(values, viscosity, "lubricant.temperature_viscosity");
    in_file_of(values, [&] { check(oil); });
    oil.pressure_viscosity = isoviscous_coefficient(oil);
  } else {
    oil.pressure_viscosity = needed(values, viscosity, alpha);
    in_file_of(values, [&] { check(oil); });
  }
  return oil;
}

std::optional<ThermalOil> read_thermal_oil(const ParameterValues& values) {
  const std::string given = "lubricant.temperature_viscosity";
  const Lubricant oil = read_lubricant(values);
  const double beta = by_free_volume(oil) ? free_volume_thinning(oil) : values.has(given) ? values.real(given) : 0.0;
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

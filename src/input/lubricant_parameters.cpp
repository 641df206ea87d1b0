// What the oil is like. The constants of its laws, and which laws need what, are as the laws have them
// (lubricant/lubricant.hpp).
#include <algorithm>
#include <iterator>

#include "input/parameter_records.hpp"
#include "lubricant/thermal_oil.hpp"

namespace gearfilm {
namespace {

/// "a", "a and b", "a, b and c".
std::string enumerated(const Words& words) {
  std::string list;
  for (std::size_t n = 0; n < words.size(); ++n) {
    const bool last = n + 1 == words.size();
    list += (n == 0 ? "" : last ? " and " : ", ") + words[n];
  }
  return list;
}

template <class Laws>
Words names_of() {
  Words names;
  each_law<Laws>([&]<class Law>() { names.emplace_back(Law::name); });
  return names;
}

Words laws_with_coefficients() {
  Words names;
  each_law<AnyViscosityLaw>([&]<class Law>() {
    if (Law::takes_coefficients) names.emplace_back(Law::name);
  });
  return names;
}

std::string meaning_of_viscosity_laws() {
  std::string meaning = "growth of the viscosity with pressure, and fall with temperature";
  each_law<AnyViscosityLaw>([&]<class Law>() {
    if (!Law::meaning.empty()) meaning += "; " + std::string(Law::name) + ": " + std::string(Law::meaning);
  });
  return meaning;
}

Records isothermal_records() {
  return {
      number("viscosity", "eta_0", "Pa s", closed(1e-5, 1e4), "viscosity at ambient pressure"),
      optional("needed by " + enumerated(laws_with_coefficients()) + "; else alpha* = 1/Int eta_0/eta dp of the law",
               number("pressure_viscosity", "alpha_B", "1/Pa", closed(1e-11, 1e-6), "pressure-viscosity coefficient")),
      choice("viscosity_law", names_of<AnyViscosityLaw>(), meaning_of_viscosity_laws()),
      choice("density_law", names_of<AnyDensityLaw>(), "growth of the density with pressure")};
}

/// A constant of one or more laws.
struct LawConstant {
  OilConstant constant;
  Words laws;
};

Parameter record_of(const LawConstant& found) {
  const OilConstant& constant = found.constant;
  Parameter parameter = number(std::string(constant.name), std::string(constant.symbol), std::string(constant.unit),
                               {.lower = constant.lower, .upper = constant.upper, .lower_open = constant.lower_open},
                               std::string(constant.meaning));
  parameter.former = constant.former;
  if (const double* value = std::get_if<double>(&constant.standard)) return preset(*value, std::move(parameter));
  const std::string_view* other = std::get_if<std::string_view>(&constant.standard);
  return optional(other ? std::string(*other) : "needed by " + enumerated(found.laws), std::move(parameter));
}

Records law_records() {
  std::vector<LawConstant> all;
  const auto collect = [&]<class Law>() {
    Law().each_constant([&](double, const OilConstant& constant) {
      auto place = std::ranges::find(all, constant.name, [](const LawConstant& known) { return known.constant.name; });
      if (place == all.end()) place = all.insert(place, {constant, {}});
      place->laws.emplace_back(Law::name);
    });
  };
  each_law<AnyDensityLaw>(collect);
  each_law<AnyViscosityLaw>(collect);
  Records records;
  std::ranges::transform(all, std::back_inserter(records), record_of);
  return records;
}

Records thermal_oil_records() {
  const ThermalOil standard;
  return {optional("needed by thermal.model with " + enumerated(laws_with_coefficients()),
                   number("temperature_viscosity", "beta", "1/K", closed(0.001, 0.2),
                          "-d ln eta/dT at thermal.temperature and ambient pressure")),
          preset(standard.conductivity, number("conductivity", "k_0", "W/(m K)", left_open(0.01, 10),
                                               "thermal conductivity at ambient pressure (an assumption)")),
          preset(standard.conductivity_pressure_1, number("conductivity_pressure_1", "c_1", "1/Pa", closed(0, 1e-8),
                                                          "k = k_0 (1 + c_1 p/(1 + c_2 p)) (an assumption)")),
          preset(standard.conductivity_pressure_2,
                 number("conductivity_pressure_2", "c_2", "1/Pa", closed(0, 1e-8), "see c_1 (an assumption)")),
          preset(standard.density, number("density", "rho_0", "kg/m^3", closed(100, 10000),
                                          "density at ambient pressure (an assumption)")),
          preset(standard.heat_capacity,
                 number("heat_capacity", "c", "J/(kg K)", closed(100, 10000), "specific heat (an assumption)")),
          preset(standard.expansion, number("expansion", "beta_rho", "1/K", closed(0, 0.01),
                                            "-d ln rho/dT, which acts on films with thermal.model film"))};
}

}  // namespace

std::vector<Parameter> lubricant_records() {
  return section("lubricant", Scope::any, joined(isothermal_records(), law_records(), thermal_oil_records()));
}

}  // namespace gearfilm

#include "input/case_traction.hpp"

#include <array>
#include <cmath>

#include "gearfilm/error.hpp"
#include "input/case_lubricant.hpp"

namespace gearfilm {
namespace {

ShearLawKind law_named(const std::string& name) {
  if (name == "newtonian") return ShearLawKind::newtonian;
  if (name == "carreau") return ShearLawKind::carreau;
  return name == "coulomb" ? ShearLawKind::coulomb : ShearLawKind::eyring;
}

ShearLaw read_law(const ParameterValues& values) {
  ShearLaw law{.kind = law_named(values.text("friction.law")),
               .eyring_stress = values.real("friction.eyring_stress"),
               .carreau_modulus = values.real("friction.carreau_modulus"),
               .carreau_exponent = values.real("friction.carreau_exponent"),
               .limiting_ratio = values.real("friction.limiting_ratio"),
               .limiting_stress = values.real("friction.limiting_stress")};
  if (law.kind != ShearLawKind::coulomb) return law;
  if (!values.has("friction.coefficient")) {
    values.refuse("friction.law", "is coulomb, but 'friction.coefficient' is missing; give a number in [0, 1]");
  }
  law.coefficient = values.real("friction.coefficient");
  return law;
}

HeatOptions read_heat(const ParameterValues& values) {
  const std::optional<ThermalOil> oil = read_thermal_oil(values);
  if (!oil) {
    values.refuse("thermal.model",
                  "is " + values.text("thermal.model") +
                      ", but 'lubricant.temperature_viscosity' is missing; give -d ln eta/dT in 1/K (about 0.04 for a "
                      "mineral oil)");
  }
  return {
      .oil = *oil, .points = values.integer("thermal.points"), .couple_film = values.text("thermal.model") == "film"};
}

bool shears_in_film(const ParameterValues& values, const ShearLaw& law) {
  if (!values.yes("friction.in_film")) return false;
  if (law.kind == ShearLawKind::coulomb) {
    values.refuse("friction.in_film",
                  "is yes, but Coulomb friction does not depend on the viscosity; use friction.law eyring or "
                  "carreau, or friction.in_film no");
  }
  return law.kind != ShearLawKind::newtonian;
}

// A surface that stands still or runs against the film is warmed by what lies before it.
void check_sliding(const ParameterValues& values) {
  const std::string sliding = "contact.sliding_velocity";
  if (values.text("case.kind") == "gear_pair") return;
  const double largest = 2.0 * values.real("contact.entrainment_velocity");
  if (std::abs(values.real(sliding)) < largest) return;
  values.refuse(sliding, "is " + format_value(values.real(sliding)) +
                             " m/s, at which one surface stands still or moves backwards; give less than twice "
                             "contact.entrainment_velocity, " +
                             format_value(largest) + " m/s");
}

}  // namespace

std::optional<TractionModel> read_traction(const ParameterValues& values) {
  const bool heated = values.text("thermal.model") != "none";
  if (values.text("friction.law") == "none") {
    if (values.yes("friction.in_film")) {
      values.refuse("friction.in_film",
                    "is yes, but 'friction.law' is none; choose the shear law of the oil, such as eyring");
    }
    if (!heated) return {};
    values.refuse("thermal.model",
                  "is " + values.text("thermal.model") +
                      ", but 'friction.law' is none; choose the shear law that the heat follows from, such as eyring");
  }
  check_sliding(values);
  TractionModel model;
  model.boundary_coefficient = values.real("friction.boundary_coefficient");
  model.law = read_law(values);
  model.shear_couples_film = shears_in_film(values, model.law);
  const std::array<std::string, 2> conductivity = values.body_keys("conductivity");
  const std::array<std::string, 2> density = values.body_keys("density");
  const std::array<std::string, 2> heat_capacity = values.body_keys("heat_capacity");
  const std::array<std::string, 2> bulk = {"thermal.bulk_pinion", "thermal.bulk_wheel"};
  for (std::size_t k = 0; k < bulk.size(); ++k) {
    model.bodies[k] = {.temperature = values.real_if_given(bulk[k]).value_or(values.real("thermal.temperature")),
                       .conductivity = values.real(conductivity[k]),
                       .density = values.real(density[k]),
                       .heat_capacity = values.real(heat_capacity[k])};
  }
  if (heated) model.heat = read_heat(values);
  return model;
}

}  // namespace gearfilm

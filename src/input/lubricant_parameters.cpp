// What the oil is like.
#include "gearfilm/input/parameter_records.hpp"
#include "gearfilm/lubricant/thermal_oil.hpp"

namespace gearfilm {
namespace {

Records isothermal_records() {
  return {
      number("viscosity", "eta_0", "Pa s", closed(1e-5, 1e4), "viscosity at ambient pressure"),
      optional("needed by roelands and barus; else alpha* = 1/Int eta_0/eta dp of the law",
               number("pressure_viscosity", "alpha_B", "1/Pa", closed(1e-11, 1e-6), "pressure-viscosity coefficient")),
      choice("viscosity_law", {"roelands", "barus", "doolittle", "yasutomi"},
             "growth of the viscosity with pressure, and fall with temperature; doolittle: by the free volume of "
             "Tait's law; yasutomi: the improved form"),
      choice("density_law", {"dowson_higginson", "incompressible", "tait"}, "growth of the density with pressure")};
}

Records free_volume_records() {
  const std::string tait = "needed by tait and doolittle", doolittle = "needed by doolittle";
  const std::string yasutomi = "needed by yasutomi";
  return {
      optional("thermal.temperature", number("reference_temperature", "T_R", "K", closed(150, 800),
                                             "at which the constants of tait and doolittle hold")),
      optional(tait, number("tait_modulus", "K_R", "Pa", closed(1e7, 1e12), "tait: isothermal bulk modulus at T_R")),
      optional(tait, number("tait_slope", "K'", "-", left_open(1, 50), "tait: its derivative by pressure")),
      preset(0.0, number("tait_softening", "beta_K", "1/K", closed(0, 0.1), "tait: K = K_R exp[-beta_K (T - T_R)]")),
      preset(0.0, number("tait_expansion", "a_v", "1/K", closed(0, 0.01), "tait: V/V_R = 1 + a_v (T - T_R)")),
      optional(doolittle, number("doolittle_factor", "B", "-", left_open(0, 50), "doolittle: factor")),
      optional(doolittle,
               number("doolittle_occupied", "R_0", "-", left_open(0.05, 0.99), "doolittle: occupied volume over V_R")),
      preset(0.0, number("doolittle_expansion", "eps_c", "1/K", closed(-0.01, 0.01),
                         "doolittle: occupied volume over that at T_R, 1 + eps_c (T - T_R)")),
      optional(yasutomi, number("yasutomi_glass_temperature", "T_g0", "K", closed(50, 500),
                                "yasutomi: glass transition at ambient pressure")),
      optional(yasutomi, number("yasutomi_a1", "A_1", "K", closed(0, 5000), "yasutomi: T_g0 + A_1 ln(1 + A_2 p)")),
      optional(yasutomi, number("yasutomi_a2", "A_2", "1/Pa", closed(0, 1e-6), "yasutomi: see A_1")),
      optional(yasutomi, number("yasutomi_b1", "b_1", "1/Pa", closed(0, 1e-6), "yasutomi: F = (1 + b_1 p)^b_2")),
      optional(yasutomi, number("yasutomi_b2", "b_2", "-", closed(-5, 0), "yasutomi: see b_1")),
      optional(yasutomi, number("yasutomi_c1", "C_1", "-", left_open(0, 100), "yasutomi: factor")),
      optional(yasutomi, number("yasutomi_c2", "C_2", "K", left_open(0, 1000), "yasutomi: temperature"))};
}

Records thermal_oil_records() {
  const ThermalOil standard;
  return {optional("needed by thermal.model with roelands and barus",
                   number("temperature_viscosity", "beta", "1/K", closed(0.001, 0.2),
                          "-d ln eta/dT at thermal.temperature and ambient pressure")),
          preset(standard.conductivity, number("conductivity", "k_0", "W/(m K)", left_open(0.01, 10),
                                               "thermal conductivity at ambient pressure (an assumption)")),
          preset(standard.conductivity_pressure_1, number("conductivity_pressure_1", "c_1", "1/Pa", closed(0, 1e-8),
                                                          "k = k_0 (1 + c_1 p/(1 + c_2 p)) (an assumption)")),
          preset(standard.conductivity_pressure_2,
                 number("conductivity_pressure_2", "c_2", "1/Pa", closed(0, 1e-8), "see c_1 (an assumption)")),
          preset(standard.density,
                 number("density", "rho_0", "kg/m^3", closed(100, 10000), "at ambient pressure (an assumption)")),
          preset(standard.heat_capacity,
                 number("heat_capacity", "c", "J/(kg K)", closed(100, 10000), "specific heat (an assumption)")),
          preset(standard.expansion, number("expansion", "beta_rho", "1/K", closed(0, 0.01),
                                            "-d ln rho/dT, which films feel that feel their heat"))};
}

}  // namespace

std::vector<Parameter> lubricant_records() {
  return section("lubricant", Scope::any,
                 joined(joined(isothermal_records(), free_volume_records()), thermal_oil_records()));
}

}  // namespace gearfilm

// What friction and heat in the films depend on.
#include <algorithm>
#include <iterator>

#include "input/parameter_records.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {
namespace {

Records friction_records() {
  const ShearLaw standard;
  return section(
      "friction", Scope::any,
      {choice(
           "law", {"none", "newtonian", "eyring", "carreau", "coulomb"},
           "shear law of the oil: none, no friction is computed; Newton's, Eyring's or Carreau's law; coulomb, a given "
           "coefficient of friction"),
       preset(standard.eyring_stress, number("eyring_stress", "tau_0", "Pa", left_open(1e5, 1e8),
                                             "eyring: stress at which the oil begins to thin (an assumption)")),
       preset(standard.carreau_modulus, number("carreau_modulus", "G", "Pa", left_open(1e3, 1e9),
                                               "carreau: stress at which the oil begins to thin (an assumption)")),
       preset(standard.carreau_exponent,
              number("carreau_exponent", "n", "-", left_open(0.1, 1), "carreau: exponent (an assumption)")),
       preset(standard.limiting_ratio, number("limiting_ratio", "Lambda", "-", closed(0, 0.5),
                                              "largest shear stress over pressure; 0: no limit (an assumption)")),
       preset(standard.limiting_stress, number("limiting_stress", "tau_L0", "Pa", closed(0, 1e9),
                                               "shear stress below which it is not limited (an assumption)")),
       optional("needed by coulomb", number("coefficient", "mu_c", "-", closed(0, 1), "coulomb: its coefficient")),
       preset(TractionModel().boundary_coefficient,
              number("boundary_coefficient", "mu_b", "-", closed(0, 1),
                     "friction of asperities that touch, with roughness.model (an assumption)")),
       choice("in_film", {"no", "yes"},
              "the film feels the shear law: Reynolds' equation of an oil that is not Newtonian")});
}

Records motion_records() {
  return section("friction", Scope::gear_pair,
                 {choice("in_motion", {"no", "yes"}, "friction acts on the motion of the pair too")});
}

Records thermal_records() {
  const HeatOptions standard;
  const Range kelvin = closed(200, 800);
  return section(
      "thermal", Scope::any,
      {choice(
           "model", {"none", "friction", "film"},
           "heat: none, the film is isothermal; friction, the energy equation across the film gives temperatures and "
           "friction, which do not act on the film; film, they do"),
       preset(standard.oil.temperature,
              number("temperature", "T_0", "K", kelvin,
                     "temperature of the oil that enters, at which lubricant.viscosity holds")),
       optional("thermal.temperature",
                number("bulk_pinion", "T_b1", "K", kelvin, "temperature of the pinion's teeth, or of body 1")),
       optional("thermal.temperature",
                number("bulk_wheel", "T_b2", "K", kelvin, "temperature of the wheel's teeth, or of body 2")),
       preset(standard.points, whole("points", "N_z", odd(5, 129), "points across the film"))});
}

}  // namespace

std::vector<Parameter> heated_body_records(const std::string& subscript, const std::string& ending) {
  const HeatedBody steel;
  return {
      preset(steel.conductivity,
             number("conductivity" + ending, "k_" + subscript, "W/(m K)", closed(0.01, 1000), "thermal conductivity")),
      preset(steel.density, number("density" + ending, "rho_" + subscript, "kg/m^3", closed(100, 30000), "density")),
      preset(steel.heat_capacity, number("heat_capacity" + ending, "c_" + subscript, "J/(kg K)", closed(50, 10000),
                                         "specific heat capacity"))};
}

std::vector<Parameter> traction_records() { return joined(friction_records(), motion_records(), thermal_records()); }

}  // namespace gearfilm

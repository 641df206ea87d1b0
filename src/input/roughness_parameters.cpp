// What films between rough surfaces depend on.
#include "input/parameter_records.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

std::vector<Parameter> roughness_of_body_records(const std::string& subscript, const std::string& ending) {
  return {optional("smooth", number("roughness" + ending, "Rq_" + subscript, "m", closed(0, 1e-4),
                                    "roughness of the surface, root mean square")),
          optional("from the root mean square",
                   number("roughness_ra" + ending, "Ra_" + subscript, "m", closed(0, 1e-4),
                          "roughness of the surface, arithmetic mean, in the place of Rq = (pi/2)^(1/2) Ra"))};
}

std::vector<Parameter> lay_records() {
  return {preset(1.0, number("lay", "gamma", "-", closed(0.11, 9),
                             "correlation length of the roughness along the entrainment over that across it: below 1 "
                             "ground along the face, above 1 finished along the profile"))};
}

std::vector<Parameter> roughness_records() {
  const AsperityOptions standard;
  Records records = section(
      "roughness", Scope::any,
      {choice("model", {"none", "stochastic"},
              "none: films between smooth surfaces; stochastic: asperities carry a part of the load by the statistics "
              "of their heights, and oil flows around them"),
       choice("asperity_law", {"zhao_maietta_chang", "greenwood_williamson", "greenwood_tripp", "exponential", "table"},
              "pressure of the asperities by the gap of the mean planes: elastic and plastic summits; elastic ones of "
              "one surface, or of both; exponential in the mean gap; roughness.table"),
       preset(standard.density_product,
              number("asperity_density_product", "n beta sigma", "-", closed(0.0194, 0.2),
                     "density of the summits times their radius times the roughness (an assumption)")),
       preset(standard.slope, number("asperity_slope", "sigma/beta", "-", closed(1e-5, 0.1),
                                     "roughness over the radius of the summits (an assumption)")),
       preset(standard.hardness, number("hardness", "H", "Pa", closed(1e8, 3e10),
                                        "indentation hardness of the softer surface (an assumption: case-hardened)")),
       choice("summit_shift", {"yes", "no"},
              "the plane of the summits lies above that of the surface, by McCool's relation"),
       optional("needed by exponential",
                number("exponential_pressure", "p_0", "Pa", closed(1e6, 1e12), "exponential: pressure at no gap")),
       preset(standard.exponential_gap, number("exponential_gap", "g", "-", closed(0.1, 2),
                                               "exponential: gap over sigma by which the pressure falls by e")),
       optional("needed by table",
                word("table",
                     "file with gaps over sigma and pressures of the asperities [Pa], one point a line; # begins a "
                     "comment; a name in a case file is relative to that file")),
       choice("mean_gap", {"gaussian", "nominal"},
              "what oil fills: the mean of the open gaps of Gaussian heights, or the gap of the mean planes")});
  const Range coefficient = closed(0, 1e-9);
  return joined(std::move(records),
                section("wear", Scope::any,
                        {optional("no wear", number("coefficient_pinion", "k_1", "m^2/N", coefficient,
                                                    "wear depth of the pinion, or of body 1, over sliding distance "
                                                    "and pressure of the asperities")),
                         optional("no wear", number("coefficient_wheel", "k_2", "m^2/N", coefficient,
                                                    "the same of the wheel, or of body 2"))}));
}

}  // namespace gearfilm

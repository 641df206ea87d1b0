// What films between rough surfaces depend on.
#include "input/parameter_records.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

std::vector<Parameter> roughness_of_body_records(const std::string& subscript, const std::string& ending) {
  return {optional("smooth", number("roughness" + ending, "Rq_" + subscript, "m", closed(0, 1e-4),
                                    "roughness of the surface, root mean square")),
          optional("from the root mean square",
                   number("roughness_ra" + ending, "Ra_" + subscript, "m", closed(0, 1e-4),
                          "roughness of the surface, arithmetic mean, in the place of Rq = (pi/2)^(1/2) Ra")),
          optional("from the root mean square",
                   number("roughness_rz" + ending, "Rz_" + subscript, "m", closed(0, 1e-3),
                          "roughness of the surface, mean peak to valley, in the place of Rq, of which it says little: "
                          "Ra = Rz/5.3 (an assumption)"))};
}

std::vector<Parameter> lay_records() {
  return {preset(1.0, number("lay", "gamma", "-", closed(0.11, 9),
                             "correlation length of the roughness along the entrainment over that across it: below 1 "
                             "ground along the face, above 1 finished along the profile"))};
}

namespace {

Records topography_records() {
  Records records = {
      choice("direction", {"transverse", "longitudinal"},
             "transverse: crests of the waves lie along the face and travel with the flank; longitudinal: along the "
             "rolling, equally on both sides of the middle of the face"),
      optional("a quarter of the contact's half-width at the pitch point",
               number("cutoff", "lambda_c", "m", closed(1e-8, 0.1),
                      "wavelength down to which films follow measured profiles; what is shorter belongs to the "
                      "statistics"))};
  for (const std::string body : {"1", "2"}) {
    const std::string of = body == "1" ? "pinion" : "wheel";
    records.push_back(optional("no waves", number("amplitude_" + body, "A_" + body, "m", closed(0, 1e-3),
                                                  "amplitude of the waves on the flanks of the " + of)));
    records.push_back(optional("no waves", number("wavelength_" + body, "Lambda_" + body, "m", closed(1e-7, 1),
                                                  "their length, along the flank or the face")));
    records.push_back(preset(0.0, number("phase_" + body, "phi_" + body, "rad", closed(-7, 7),
                                         "their phase where the involute begins on its base circle")));
  }
  return records;
}

Records worn_flanks_records() {
  return {optional("needed by wear", number("cycles", "N", "-", closed(1, 1e12),
                                            "revolutions of the pinion after which flanks are to be known")),
          preset(0.1, number("largest_step", "", "-", closed(1e-3, 10),
                             "depth over the roughness by which a flank wears at most until its profile is "
                             "computed with again")),
          preset(201, whole("points", "", closed(11, 10001), "places along a flank at which wear is kept")),
          optional("roughness does not change", number("final_roughness", "sigma_inf", "m", closed(1e-9, 1e-4),
                                                       "roughness of both flanks together that asperities run in to")),
          optional("roughness does not change",
                   number("running_in_work", "W_r", "J/m^2", closed(1e-3, 1e15),
                          "work of the asperities on the area of a flank in which it comes nearer by a factor e"))};
}

}  // namespace

std::vector<Parameter> surface_record() {
  return {optional("none",
                   word("surface",
                        "measured profile of the flank: length of the involute from its base circle [m] and height "
                        "out of the metal [m], one point a line, # begins a comment; or a file .sdf of ISO 25178-71 "
                        "in ASCII, whose middle is taken to lie at the pitch point; a name in a case file is relative "
                        "to that file"))};
}

std::vector<Parameter> roughness_records() {
  const AsperityOptions standard;
  Records records = section(
      "roughness", Scope::any,
      {choice("model", {"none", "stochastic", "deterministic", "both"},
              "none: films between smooth surfaces; stochastic: asperities carry a part of the load by the statistics "
              "of their heights, and oil flows around them; deterministic: films follow waves and measured profiles "
              "that travel with the flanks of a gear pair; both: they do, with asperities beneath"),
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
  return joined(std::move(records), section("roughness", Scope::gear_pair, topography_records()),
                section("wear", Scope::any,
                        {optional("no wear", number("coefficient_pinion", "k_1", "m^2/N", coefficient,
                                                    "wear depth of the pinion, or of body 1, over sliding distance "
                                                    "and pressure of the asperities")),
                         optional("no wear", number("coefficient_wheel", "k_2", "m^2/N", coefficient,
                                                    "the same of the wheel, or of body 2"))}),
                section("wear", Scope::gear_pair, worn_flanks_records()));
}

}  // namespace gearfilm

// What stresses below films, and fatigue of flanks, depend on.
#include "fatigue/fatigue_model.hpp"
#include "input/parameter_records.hpp"

namespace gearfilm {

std::vector<Parameter> stress_records() {
  return section(
      "stress", Scope::any,
      {choice("model", {"none", "row", "field"},
              "none: no stresses below films; row: in the section below the row that carries most; field: the von "
              "Mises stress below all nodes too, at the depth where it is largest, wherever fields are written"),
       choice("rows", {"most_loaded", "all"},
              "rows below which films that travel have stresses: the one that carries most of the dry contact at rest, "
              "off the ends of the face; or all, but no nearer to each other than 1/16 of the width, with a map of the "
              "flanks below each"),
       preset(2.0, number("depth_max", "z_max", "-", left_open(0.1, 10),
                          "deepest place, in half-axes a of the reference contact")),
       preset(24, whole("points", "n", closed(4, 200), "depths, closer to each other at the surface")),
       preset(0.05, number("every", "", "-", closed(0, 1),
                           "way of the material, in a, after which stresses of a march are computed again; 0: at every "
                           "time step"))});
}

std::vector<Parameter> fatigue_records() {
  const RiskOptions risk;
  const FatigueModel model;
  return section(
      "fatigue", Scope::gear_pair,
      {choice("criterion", {"none", "dang_van"},
              "none; or Dang Van's shear stress of every point of the flanks that contacts pass over"),
       preset(model.dang_van.alpha,
              number("alpha", "alpha", "-", closed(0, 2),
                     "weight of the hydrostatic stress, 3 (tau_w/sigma_w - 1/2) (an assumption)")),
       choice("compression", {"yes", "no"},
              "hydrostatic pressure helps, as the criterion has it; no: tension alone counts"),
       optional("fatigue.shear_per_hardness, where hardness is given",
                number("torsion_limit", "tau_w", "Pa", left_open(0, 5e9),
                       "limit of the criterion at any depth: fatigue strength in reversed torsion")),
       preset(model.shear_per_hardness, number("shear_per_hardness", "", "Pa/HV", left_open(0, 2e6),
                                               "limit of the criterion over the hardness at a depth (an assumption)")),
       preset(model.flank_points,
              whole("flank_points", "", closed(11, 2001), "points along each flank, from one end to the other")),
       preset(model.margin, number("margin", "", "-", closed(0, 5),
                                   "part of the flanks at their ends, in a, where contacts begin or end under load and "
                                   "half-spaces do not hold: left out of largest values")),
       preset(risk.stress_exponent,
              number("stress_exponent", "c", "-", left_open(1, 30), "of the risk of failure by rolling fatigue")),
       preset(risk.depth_exponent, number("depth_exponent", "h", "-", closed(0, 5), "of the same")),
       preset(risk.weibull_slope, number("weibull_slope", "e", "-", closed(0.5, 5), "scatter of lives")),
       preset(risk.threshold,
              number("threshold", "tau_u", "Pa", at_least(0), "orthogonal shear stress that does no harm"))});
}

std::vector<Parameter> flank_material_records(const std::string& subscript) {
  const std::string with_others = "not known; needs the other two of surface_hardness, core_hardness, case_depth";
  const Range hardness = closed(100, 1200);
  const std::string lines = ", one point a line; # begins a comment; a name in a case file is relative to that file";
  return {optional("not known", number("yield_stress", "sigma_y" + subscript, "Pa", closed(1e7, 1e10),
                                       "yield stress of the flank, above whose elastic limit contacts are warned of")),
          optional(with_others, number("surface_hardness", "HV_s" + subscript, "HV", hardness,
                                       "hardness at the surface of a case-hardened flank")),
          optional(with_others, number("core_hardness", "HV_c" + subscript, "HV", hardness, "hardness of its core")),
          optional(with_others, number("case_depth", "CHD_" + subscript, "m", left_open(0, 0.05), "depth of 550 HV")),
          optional("by the three numbers", word("hardness_file", "depth [m] and hardness [HV]" + lines)),
          choice("residual_stress", {"none", "hardness", "file"},
                 "constant stress along the surface: none, by the hardness over that of the core (Lang), or by "
                 "residual_file"),
          optional("none", word("residual_file", "depth [m] and residual stress [Pa], tension positive" + lines))};
}

}  // namespace gearfilm

// What the drawing of a gear pair says.
#include <algorithm>
#include <iterator>

#include "input/parameter_records.hpp"

namespace gearfilm {
namespace {

// What both gears have; subscript 1 is the pinion, 2 the wheel.
Records one_gear_records(const std::string& subscript) {
  const std::string without_inertia = "none; give both inertias, gear.equivalent_mass, or neither";
  return {
      whole("teeth", "Z_" + subscript, closed(3, 10000), "number of teeth"),
      number("outer_radius", "R_a" + subscript, "m", closed(1e-4, 10), "radius of the tip circle"),
      number("crowning", "mag_" + subscript, "m", closed(0, 0.01), "lead crowning over half the face width"),
      number("youngs_modulus", "E_" + subscript, "Pa", left_open(1e5, 1e13), "Young's modulus"),
      number("poisson_ratio", "nu_" + subscript, "-", right_open(0, 0.5), "Poisson's ratio"),
      optional(without_inertia,
               number("inertia", "I_g" + subscript, "kg m^2", closed(1e-15, 1e9), "moment of inertia about its axis")),
      optional("no backlash at the centre distance, both tips cut alike",
               number("profile_shift", "x_" + subscript, "-", closed(-2, 3), "profile shift of the teeth")),
      optional("that of a rack with a dedendum of 1.25 m_n",
               number("root_radius", "r_f" + subscript, "m", closed(1e-4, 10), "radius of the root circle")),
      optional("0.38 m_n, or the largest that fits", number("hob_tip_radius", "rho_f" + subscript, "m", closed(0, 0.1),
                                                            "rounding of the tips of the rack that made the teeth")),
      optional("none: the body is rigid", number("bore_radius", "r_i" + subscript, "m", closed(1e-4, 10),
                                                 "radius of the bore, where the body is held")),
      preset(0.0, number("tip_relief", "C_a" + subscript, "m", closed(0, 0.01),
                         "material removed at the tip, along the line of action")),
      optional("by the start of the relief", number("tip_relief_length", "L_a" + subscript, "m", left_open(0, 1),
                                                    "length of roll of the tip relief")),
      optional("by its length",
               number("tip_relief_start_radius", "", "m", closed(1e-4, 10), "radius at which the tip relief begins")),
      optional("by its length", number("tip_relief_start_roll_deg", "", "deg", closed(0, 360),
                                       "roll angle at which the tip relief begins")),
      choice("tip_relief_shape", {"parabolic", "linear", "smooth"},
             "with the distance u into it: u^2, u, or u^2 (3 - 2 u), which has no kink"),
      preset(0.0, number("root_relief", "C_f" + subscript, "m", closed(0, 0.01),
                         "material removed at the start of the active profile")),
      optional("none", number("root_relief_length", "L_f" + subscript, "m", left_open(0, 1),
                              "length of roll of the root relief")),
      choice("root_relief_shape", {"parabolic", "linear", "smooth"}, "as tip_relief_shape"),
      preset(0.0, number("profile_slope", "", "m", closed(-0.01, 0.01),
                         "material removed at the tip by a profile that is inclined, none at its start")),
      preset(0.0, number("profile_crowning", "", "m", closed(-0.01, 0.01),
                         "material removed at both ends of a profile that is crowned, none in its middle")),
      optional("none", word("profile_file",
                            "measured profile: radius of curvature of the flank [m] and material removed [m], one "
                            "point a line; # begins a comment; a name in a case file is relative to that file")),
      optional("none", word("pitch_errors",
                            "list of cumulative pitch errors along the line of action [m], one a tooth, positive where "
                            "the flank stands proud")),
      optional("none", word("pitch_errors_file",
                            "the same in a file, separated by blanks, commas or lines; # begins a comment; a name in a "
                            "case file is relative to that file")),
  };
}

Records pinion_records() {
  Records records =
      joined(one_gear_records("1"), lead_records(), heated_body_records("1"), roughness_of_body_records("1"),
             lay_records(), surface_record(), flank_material_records("1"), supports_of_gear_records("1"));
  records.push_back(number("speed_rpm", "Omega_1", "rpm", closed(1e-3, 1e6), "rotational speed of the pinion"));
  records.push_back(number("torque", "T_g1", "N m", closed(1e-6, 1e9), "torque on the pinion"));
  return section("pinion", Scope::gear_pair, std::move(records));
}

Records wheel_records() {
  return section("wheel", Scope::gear_pair,
                 joined(one_gear_records("2"), lead_records(), heated_body_records("2"), roughness_of_body_records("2"),
                        lay_records(), surface_record(), flank_material_records("2"), supports_of_gear_records("2")));
}

Records gear_records() {
  return section(
      "gear", Scope::gear_pair,
      joined(
          end_face_records(),
          Records{
              preset(0.0, number("misalignment", "", "m", closed(-1e-2, 1e-2),
                                 "by how much both flanks part over the face, towards positive y")),
              number("module", "m_n", "m", closed(1e-5, 0.1), "normal module"),
              number("pressure_angle_deg", "alpha", "deg", closed(5, 45), "pressure angle of the basic rack"),
              number("centre_distance", "a_w", "m", closed(1e-4, 20), "working centre distance"),
              number("face_width", "F_w", "m", closed(1e-5, 5), "face width"),
              optional("from both inertias; without them no vibration",
                       number("equivalent_mass", "m_ge", "kg", closed(1e-9, 1e9),
                              "mass of both gears along the line of action")),
              choice("load_model", {"point", "line_equivalent"},
                     "load of the contact: the tooth force T_g1/R_b1 as it is, or the point load whose ellipse has the "
                     "half-axis a of the line contact under that force"),
              choice("tooth_compliance", {"none", "weber", "sainsot", "table"},
                     "bending of the teeth: rigid; beam on the foundation of Weber and Banaschek; beam on the ring of "
                     "Sainsot, "
                     "Velex and Duverger; from gear.compliance_file"),
              optional("none",
                       word("compliance_file",
                            "position on the line of action [m] and compliance of a pair of teeth [m/N], one point a "
                            "line; a name in a case file is relative to that file")),
              preset(1.0, number("compliance_factor", "", "-", left_open(0, 100),
                                 "factor on the compliance of computed teeth and foundations")),
              preset(0.0,
                     number("mesh_compliance", "c_s", "m/N", closed(0, 1e-3),
                            "compliance of shafts and bearings along the line of action, under the sum of the forces")),
              choice("profile_local", {"offset", "field"},
                     "flanks act on films as one gap at the contact's place, or as a shape along the contact too"),
              choice("body_coupling", {"yes", "no"}, "teeth bent by their neighbours' forces, where bores are given"),
              optional("reverse flanks never touch",
                       number("backlash", "j_n", "m", closed(0, 0.1),
                              "normal backlash along the line of action: the teeth are thinner by it, and beyond it "
                              "their reverse flanks touch, dry"))}));
}

}  // namespace

std::vector<Parameter> gear_pair_records() { return joined(pinion_records(), wheel_records(), gear_records()); }

}  // namespace gearfilm

// What a gear pair is joined to: shafts, bearings, motor and load.
#include "input/parameter_records.hpp"

namespace gearfilm {
namespace {

const Range inertia = closed(1e-15, 1e9), stiffness = closed(1e-3, 1e18), damping = closed(0, 1e12),
            ratio = right_open(0, 1);

/// Of a machine on a shaft to the gear on its side.
Records machine_records(const std::string& gear, const std::string& subscript) {
  return {optional("nothing on that side", number("inertia", "I_" + subscript, "kg m^2", inertia, "moment of inertia")),
          optional("needed with an inertia", number("shaft_stiffness", "k_" + subscript, "N m/rad", stiffness,
                                                    "torsional stiffness of the shaft to the " + gear)),
          optional("none", number("shaft_damping", "c_" + subscript, "N m s/rad", damping, "damping of that shaft")),
          optional("constant torque",
                   word("torque_harmonics",
                        "fluctuations of the torque: order of the " + gear +
                            "'s shaft (or frequency, 300Hz), amplitude over the mean, phase in degrees: 1 0.1 0, 6 "
                            "0.02 30; without an inertia on the " +
                            gear))};
}

}  // namespace

std::vector<Parameter> supports_of_gear_records(const std::string& subscript) {
  const std::string rigid = "rigid";
  return {optional("that of a disc on the base circle, 2 I_g" + subscript + "/R_b" + subscript + "^2",
                   number("mass", "m_" + subscript, "kg", closed(1e-9, 1e9), "mass of the gear on its bearings")),
          optional(rigid, number("bearing_stiffness", "k_b" + subscript, "N/m", stiffness,
                                 "stiffness of the gear's bearings, the same in all directions")),
          optional(rigid, number("bearing_stiffness_x", "", "N/m", stiffness,
                                 "the same along the line of centres, from the pinion to the wheel")),
          optional(rigid, number("bearing_stiffness_y", "", "N/m", stiffness, "the same across the line of centres")),
          optional("0", number("bearing_stiffness_xy", "", "N/m", closed(-1e18, 1e18), "coupling of these two")),
          optional("one bearing, or all in the middle of the gear",
                   number("bearing_span", "L_b" + subscript, "m", closed(1e-4, 20),
                          "distance of two bearings of its shaft; bearing_stiffness is then that of each")),
          optional("0", number("bearing_offset", "e_b" + subscript, "m", closed(-20, 20),
                               "of the gear's middle from that of bearing_span, towards positive y of the face; "
                               "overhung beyond half of it")),
          optional("as the other", number("bearing_stiffness_2", "", "N/m", stiffness,
                                          "of the bearing at positive y, where both differ")),
          optional("0", number("bearing_damping_ratio", "", "-", ratio,
                               "damping ratio of the bearings, at the mode that strains them most"))};
}

std::vector<Parameter> train_records() {
  Records motor = machine_records("pinion", "mot");
  motor.push_back(flag("fixed", "the motor turns at an imposed speed; its inertia then has no part"));
  return joined(section("motor", Scope::gear_pair, std::move(motor)),
                section("load", Scope::gear_pair, machine_records("wheel", "load")),
                section("train", Scope::gear_pair,
                        {optional("0", number("damping_ratio", "", "-", ratio,
                                              "damping ratio of every mode, without the share of the teeth")),
                         optional("none", word("file",
                                               "further nodes, shafts and bearings, one a line (docs/guide/"
                                               "drive-trains.md); a name in a case file is relative to that file"))}));
}

}  // namespace gearfilm

// What bounds a contact along the face.
#include "input/parameter_records.hpp"

namespace gearfilm {

Records end_relief_records(const std::string& of_what) {
  return {preset(0.0, number("end_relief", "C_e", "m", closed(0, 0.01),
                             "material removed at both ends of the face " + of_what)),
          optional("none", number("end_relief_length", "L_e", "m", closed(1e-6, 5), "length of the end relief")),
          choice("end_relief_shape", {"circular", "linear"},
                 "with the distance u into it: u^2, or u, which has a kink where it begins")};
}

Records lead_records() {
  return joined(end_relief_records("of the flank"),
                Records{preset(0.0, number("lead_slope", "", "m", closed(-1e-2, 1e-2),
                                           "material removed at the end of positive y by a lead that is inclined over "
                                           "the face, less that at the other end")),
                        optional("none", word("lead_file",
                                              "measured lead: y from the middle of the face [m] and material removed "
                                              "[m], one point a line; # begins a comment; a name in a case file is "
                                              "relative to that file")),
                        optional("as gear.face_width", number("face_width", "", "m", closed(1e-5, 5),
                                                              "width of the gear where it goes on beyond the face"))});
}

Records end_face_records() {
  return {choice("end_face", {"free", "half_space", "mirror"},
                 "solids at the ends of a loaded face: a free plane at a right angle to the flank, a half-space that "
                 "goes on, or a mirror image of the pressure times end_face_factor"),
          preset(1.39, number("end_face_factor", "psi", "-", closed(0, 3),
                              "factor of the mirror image, with end_face: mirror"))};
}

}  // namespace gearfilm

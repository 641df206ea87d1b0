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

Records end_face_records() {
  return {choice("end_face", {"free", "half_space", "mirror"},
                 "solids at the ends of a loaded face: a free plane at a right angle to the flank, a half-space that "
                 "goes on, or a mirror image of the pressure times end_face_factor"),
          preset(1.39, number("end_face_factor", "psi", "-", closed(0, 3),
                              "factor of the mirror image, with end_face: mirror"))};
}

}  // namespace gearfilm

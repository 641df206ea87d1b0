// What stresses below films depend on.
#include "input/parameter_records.hpp"

namespace gearfilm {

std::vector<Parameter> stress_records() {
  return section(
      "stress", Scope::any,
      {choice("model", {"none", "row", "field"},
              "none: no stresses below films; row: in the section y = 0; field: the von Mises stress below all nodes "
              "too, at the depth where it is largest, wherever fields are written"),
       preset(2.0, number("depth_max", "z_max", "-", left_open(0.1, 10),
                          "deepest place, in half-axes a of the reference contact")),
       preset(24, whole("points", "n", closed(4, 200), "depths, closer to each other at the surface")),
       preset(0.05, number("every", "", "-", closed(0, 1),
                           "way of the material, in a, after which stresses of a march are computed again; 0: at every "
                           "time step"))});
}

}  // namespace gearfilm

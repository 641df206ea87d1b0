// Whether the teeth of a pair fit into each other's spaces: thickness of the teeth, backlash, clearance at the roots.
//
//   s(r) = 2 r [s/(2 r_ref) + inv alpha - inv alpha_r] ,  cos alpha_r = R_b/r      thickness at the radius r
//   j_n = 2 m sin(alpha) (sum x_0 - sum x)     normal backlash that given profile shifts leave at the centre distance;
//                                              sum x_0 leaves none (tooth_profile.hpp)
//   c = a_w - R_a - r_f                        clearance between a tip circle and the mate's root circle
#pragma once

#include <array>
#include <optional>

#include "gear/line_of_action.hpp"

namespace gearfilm {

/// Values of the pinion, then of the wheel [m].
struct ToothSpace {
  std::array<double, 2> tip_thickness{};    ///< s at the tip circle; not positive: the tooth is pointed below it
  std::array<double, 2> pitch_thickness{};  ///< s at the working pitch circle
  std::array<double, 2> tip_clearance{};    ///< of this gear's tips from the mate's root circle
  std::optional<double> implied_backlash;   ///< j_n by both profile shifts; absent unless both are given
};

/// The space by given profile shifts and root radii, and by those assumed for the others (gear_pair.hpp).
ToothSpace tooth_space(const SpurGearPair& pair);

/// Overlap of the teeth by given profile shifts beyond which they cannot mesh, over the module: more than a drawing's
/// rounding and the tolerances of teeth.
constexpr double largest_overlap = 0.1;

/// Throws InputError where what is given leaves no tooth at a tip or on the working pitch circle, makes teeth that are
/// thicker than their spaces, a root circle that lies on the active flank, a bore that reaches the root, or a tip that
/// reaches the mate's root.
void check_tooth_space(const SpurGearPair& pair, const LineOfAction& line);

}  // namespace gearfilm

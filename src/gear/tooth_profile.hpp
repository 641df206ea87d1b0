// The outline of a spur-gear tooth: involute above, fillet of the generating rack below.
//
// y runs along the tooth's centre line from the gear's centre, x(y) is half the thickness there. The rack has a tip of
// radius rho_f; h_f = r - r_f + x m is how deep it reaches below its reference line.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gear/gear_pair.hpp"

namespace gearfilm {

/// A point of the outline [m].
struct OutlinePoint {
  double y = 0.0;
  double x = 0.0;
};

/// Where a contact presses on a tooth, and how.
struct ToothLoad {
  double y = 0.0;               ///< y_c of the contact [m]
  double half_thickness = 0.0;  ///< x_c there [m]
  double angle = 0.0;           ///< alpha_F, between the load line and the normal of the centre line [rad]
  double y_axis = 0.0;          ///< y_p, where the load line meets the centre line [m]
};

class ToothProfile {
public:
  /// The profile of a gear of the pair with the profile shift x. Where the rack undercuts the tooth, the fillet ends
  /// where it cuts the involute. Throws InputError, naming the gear, where rack and root radius do not go together, or
  /// nothing of the involute is left.
  ToothProfile(const SpurGear& gear, const SpurGearPair& pair, double profile_shift, std::string name);

  double base_radius() const { return base_radius_; }          ///< R_b [m]
  double root_radius() const { return root_radius_; }          ///< r_f [m]
  double root_half_angle() const { return root_half_angle_; }  ///< theta_f [rad]
  double form_radius() const { return form_radius_; }          ///< where fillet and involute meet [m]
  bool undercut() const { return undercut_; }                  ///< the rack took the foot of the involute away
  double hob_tip_radius() const {
    return hob_tip_radius_;
  }                                                ///< rho_f [m]; smaller than asked for, where that does not fit
  double thickness() const { return thickness_; }  ///< s on the reference circle [m]

  /// The contact on the flank with the radius of curvature rho [m]. Throws InputError where rho lies on the fillet.
  ToothLoad load_at(double rho) const;
  /// The outline from the root circle, y0 = r_f cos theta_f, up to the contact at rho.
  std::vector<OutlinePoint> outline_to(double rho) const;

private:
  double half_angle(double radius) const;
  void generate_fillet(const SpurGearPair& pair, double profile_shift, double root_radius);
  OutlinePoint fillet_point(double u) const;
  void end_fillet_on_involute(double last);

  std::string name_;
  int teeth_;
  double base_radius_;
  double reference_radius_;
  double reference_angle_;  ///< inv alpha + s/(2 r)
  double thickness_ = 0.0;
  double root_radius_ = 0.0;
  double root_half_angle_ = 0.0;
  double form_radius_ = 0.0;
  bool undercut_ = false;
  double hob_tip_radius_ = 0.0;
  // Of the rack's tip: depth D of the centre of its rounding below the reference circle, its distance e_c from the
  // middle of the tip, and what the backlash takes of the tooth's half angle.
  double rack_depth_ = 0.0;
  double rack_offset_ = 0.0;
  double slack_ = 0.0;
  std::vector<OutlinePoint> fillet_;
};

/// s of a tooth on the reference circle with the profile shift x, less its half of the pair's backlash [m].
double tooth_thickness(const SpurGearPair& pair, double profile_shift);

/// s(r) of that tooth at a radius [m].
double tooth_thickness_at(double radius, const SpurGear& gear, const SpurGearPair& pair, double profile_shift);

/// r_f [m] of a gear that a rack with a dedendum of 1.25 m_n has cut with the profile shift x.
double standard_root_radius(const SpurGear& gear, const SpurGearPair& pair, double profile_shift);

/// x_1 + x_2 that leave no backlash at the centre distance.
double sum_of_profile_shifts(const SpurGearPair& pair);

/// x_1 and x_2: those given, and for the others the ones that leave no backlash at the centre distance, both tips cut
/// by the same length.
std::array<double, 2> profile_shifts(const SpurGearPair& pair);

}  // namespace gearfilm

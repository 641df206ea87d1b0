// How far a loaded tooth gives way along the line of action, per force [m/N]: a cantilever of the tooth's outline on an
// elastic foundation in a body held at its bore.
//
//   bending  int [cos(alpha_F) (y_p - y)]^2/(E* I) dy,  I = b (2x)^3/12        y from the root circle to the contact
//   shear    int 1.2 cos^2(alpha_F)/(G A) dy,  A = 2 x b        axial  int sin^2(alpha_F)/(E* A) dy
//   E* = E/(1-nu^2) (plane strain), G = E/(2(1+nu)), b the face width
// The load is taken as spread over the whole face.
#pragma once

#include "gear/tooth_profile.hpp"

namespace gearfilm {

enum class FoundationModel { weber, sainsot };

struct ToothCompliance {
  double bending = 0.0;
  double shear = 0.0;
  double axial = 0.0;
  double foundation = 0.0;

  double sum() const { return bending + shear + axial + foundation; }
};

/// The body of a gear whose bore is held.
struct BodyCompliance {
  double torsion = 0.0;     ///< c_t: of the body under any tooth's load, common to all teeth [m/N]
  double neighbour = 0.0;   ///< c_kj between teeth one pitch apart, torsion included [m/N]
  double neighbour2 = 0.0;  ///< the same, two pitches apart
};

class GearCompliance {
public:
  /// Throws InputError, naming the gear, where root, bore and outline do not go together.
  GearCompliance(const SpurGear& gear, const SpurGearPair& pair, ToothProfile profile, FoundationModel foundation,
                 const std::string& name);

  const ToothProfile& profile() const { return profile_; }
  /// Under a contact on the flank with the radius of curvature rho [m].
  ToothCompliance tooth(double rho) const;
  /// Zero without a bore.
  const BodyCompliance& body() const { return body_; }

private:
  double weber(const ToothLoad& load) const;
  double sainsot(const ToothLoad& load) const;

  ToothProfile profile_;
  double plane_modulus_;  ///< E* [Pa]
  double modulus_;
  double poisson_ratio_;
  double face_width_;
  FoundationModel foundation_;
  double bore_radius_;  ///< 0 without one
  BodyCompliance body_;
};

}  // namespace gearfilm

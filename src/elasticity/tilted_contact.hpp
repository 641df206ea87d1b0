// The dry contact along a whole face (row_contact.hpp) whose flanks are tilted against each other.
#pragma once

#include "elasticity/row_contact.hpp"

namespace gearfilm {

class TiltedContact {
public:
  /// For contacts along the face of these scales, which must outlive this.
  explicit TiltedContact(const Scales& scales);

  /// Tilted further by a slope, which opens the end at positive y. Throws SolveError where it is not found.
  FaceContact solve(double slope, double force, double relative_radius);
  /// How much of the face was loaded last [a].
  double loaded_width() const { return loaded_width_; }
  /// A slope that opens the ends of the face by a fiftieth of a^2/R_x.
  double little() const;

private:
  const Scales& scales_;
  FaceRows rows_;
  double loaded_width_ = 0.0;
};

/// -dM/dtheta [N m/rad] of the moment about the middle of the scales' face, under a force [-] at a radius: by contacts
/// that are tilted a little either way. Throws SolveError.
double tilting_stiffness(const Scales& scales, double force, double relative_radius);

}  // namespace gearfilm

// How a dry contact at one moment answers to its approach: an ellipse, or a whole face (face_law.hpp).
//
//   ellipse:  F = k approach^(3/2) ,  k the force at unit approach
#pragma once

#include <memory>

#include "contact/face_law.hpp"

namespace gearfilm {

/// Dimensionless, or in any consistent units.
class ContactLaw {
public:
  static ContactLaw of_ellipse(double force_at_unit_approach);
  static ContactLaw of_face(std::shared_ptr<const FaceLaw> face, double relative_radius);

  /// The approach of a force, from where the flanks meet.
  double approach(double force) const;
  /// The force where the contact and a spring of a compliance together approach so much; zero where they are apart.
  double force(double approach, double compliance) const;
  /// d(force)/d(approach) at a force.
  double stiffness(double force) const;

private:
  double unit_force_ = 0.0;
  std::shared_ptr<const FaceLaw> face_{};
  double relative_radius_ = 1.0;
};

}  // namespace gearfilm

#include "contact/contact_law.hpp"

#include <cmath>

#include "contact/hertz.hpp"

namespace gearfilm {

ContactLaw ContactLaw::of_ellipse(double force_at_unit_approach) {
  ContactLaw law;
  law.unit_force_ = force_at_unit_approach;
  return law;
}

ContactLaw ContactLaw::of_face(std::shared_ptr<const FaceLaw> face, double relative_radius) {
  ContactLaw law;
  law.face_ = std::move(face);
  law.relative_radius_ = relative_radius;
  return law;
}

double ContactLaw::approach(double force) const {
  if (face_) return face_->approach(force, relative_radius_);
  const double root = std::cbrt(force / unit_force_);
  return root * root;
}

double ContactLaw::force(double approach, double compliance) const {
  if (face_) return face_->force(approach, compliance, relative_radius_);
  return force_on_spring(unit_force_, compliance, approach);
}

double ContactLaw::stiffness(double force) const {
  if (face_) return face_->stiffness(force, relative_radius_);
  const double root = std::cbrt(unit_force_);
  return 1.5 * root * root * std::cbrt(force);
}

}  // namespace gearfilm

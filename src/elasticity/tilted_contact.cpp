#include "elasticity/tilted_contact.hpp"

#include <array>
#include <memory>

namespace gearfilm {
namespace {

Face tilted(const Face& face, double slope) {
  Face other = face;
  other.gap.slope += slope;
  return other;
}

/// Over the whole face, whether it is tilted or not.
FaceRows rows_of(const Scales& scales) {
  const Face& face = *scales.solids.face;
  return {face.symmetric() ? tilted(face, 1.0) : face, coarse_grading(scales), scales.length};
}

}  // namespace

TiltedContact::TiltedContact(const Scales& scales) : scales_(scales), rows_(rows_of(scales)) {}

double TiltedContact::little() const {
  constexpr double opened = 0.02;  // at the ends, in a^2/R_x
  return opened * scales_.thickness / (0.5 * scales_.solids.face->width);
}

FaceContact TiltedContact::solve(double slope, double force, double relative_radius) {
  Scales other = scales_;
  other.solids.face = std::make_shared<const Face>(tilted(*scales_.solids.face, slope));
  RowContact contact = rows_.contact(other);
  const FaceContact found = contact.solve(force, relative_radius);
  loaded_width_ = contact.loaded_width();
  return found;
}

double tilting_stiffness(const Scales& scales, double force, double relative_radius) {
  TiltedContact contact(scales);
  const double tilt = contact.little();
  std::array<double, 2> arms{};
  for (std::size_t n = 0; n < 2; ++n) {
    arms[n] = contact.solve(n == 0 ? -tilt : tilt, force, relative_radius).arm;
  }
  return scales.force(force) * scales.length * (arms[0] - arms[1]) / (2.0 * tilt);
}

}  // namespace gearfilm

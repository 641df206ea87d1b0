#include "dynamics/friction_force.hpp"

#include <array>

namespace gearfilm {

namespace {

/// F_1 and F_2 of a contact, on pinion and wheel along their flanks [N].
std::array<double, 2> forces_on_gears(const ContactRecord& contact) {
  const double sliding = contact.quantities["friction_force"], rolling = contact.quantities["rolling_force"];
  return {-sliding - rolling, sliding - rolling};
}

Eigen::VectorXd friction_on_train(const MeshModel& mesh, const std::vector<ContactRecord>& contacts) {
  const LineOfAction& line = mesh.path.line();
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const ContactRecord& contact : contacts) {
    const auto [on_pinion, on_wheel] = forces_on_gears(contact);
    sum += Eigen::Vector4d(line.radius_pinion(contact.position) * on_pinion, on_pinion,
                           line.radius_wheel(contact.position) * on_wheel, on_wheel);
  }
  return mesh.train->friction.transpose() * sum / -mesh.scales.force(1.0);
}

}  // namespace

Eigen::VectorXd friction_on_motion(const MeshModel& mesh, const std::vector<ContactRecord>& contacts) {
  if (mesh.train) return friction_on_train(mesh, contacts);
  const LineOfAction& line = mesh.path.line();
  const InertiaShares& g = *mesh.friction_couples_dynamics;
  double sum = 0.0;
  for (const ContactRecord& contact : contacts) {
    const auto [on_pinion, on_wheel] = forces_on_gears(contact);
    sum += g.pinion * line.radius_pinion(contact.position) / line.base_radius_pinion() * on_pinion -
           g.wheel * line.radius_wheel(contact.position) / line.base_radius_wheel() * on_wheel;
  }
  return Eigen::VectorXd::Constant(1, sum / mesh.scales.force(1.0));
}

}  // namespace gearfilm

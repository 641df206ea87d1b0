#include "dynamics/friction_force.hpp"

namespace gearfilm {

double friction_on_motion(const MeshModel& mesh, const std::vector<ContactRecord>& contacts) {
  const LineOfAction& line = mesh.path.line();
  const InertiaShares& g = *mesh.friction_couples_dynamics;
  double sum = 0.0;
  for (const ContactRecord& contact : contacts) {
    const double sliding = contact.quantities["friction_force"], rolling = contact.quantities["rolling_force"];
    sum += g.pinion * line.radius_pinion(contact.position) / line.base_radius_pinion() * (-sliding - rolling) -
           g.wheel * line.radius_wheel(contact.position) / line.base_radius_wheel() * (sliding - rolling);
  }
  return sum / mesh.scales.force(1.0);
}

}  // namespace gearfilm

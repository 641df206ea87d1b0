#include "mesh/reverse_flanks.hpp"

#include <cmath>

namespace gearfilm {

ReverseForce reverse_flank_force(const MeshModel& mesh, double H0, double T) {
  ReverseForce sum;
  if (!mesh.teeth.backlash() || mesh.load) return sum;
  for (const double xi : mesh.teeth.back_positions(mesh.path.position(0, T))) {
    const double approach = H0 - (*mesh.teeth.backlash() + mesh.teeth.removed(xi)) / mesh.scales.thickness;
    if (approach <= 0.0) continue;
    const ContactConditions conditions =
        meshed_contact(mesh.path.line(), mesh.scales, mesh.path.pinion_speed(), xi).conditions;
    const ContactLaw law = contact_law(mesh.scales, conditions);
    const double compliance = mesh.teeth.compliance(xi) * mesh.compliance_scale();
    const double force = law.force(approach, compliance);
    if (force <= 0.0) continue;
    sum.value += force;
    sum.slope += 1.0 / (1.0 / law.stiffness(force) + compliance);
  }
  return sum;
}

ReverseForce reverse_flank_force(const MeshModel& mesh, const Motion& motion, double T) {
  return reverse_flank_force(mesh, mesh.train ? mesh.train->back.dot(motion.q) : motion.H0(), T);
}

}  // namespace gearfilm

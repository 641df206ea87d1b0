#include "dynamics/train_rates.hpp"

#include <numeric>

#include "mesh/reverse_flanks.hpp"

namespace gearfilm {

TrainAcceleration train_acceleration(const MeshModel& mesh, const DryContacts& contacts, double T, const Motion& motion,
                                     double damping, bool derivatives) {
  const MeshTrain& train = *mesh.train;
  const std::vector<double> forces = contacts.forces(motion.H0());
  const ReverseForce back = reverse_flank_force(mesh, motion, T);
  const double damper = mesh.inertia * damping;
  const double pull = std::accumulate(forces.begin(), forces.end(), -mesh.scales.static_force) - damper * motion.V0();
  TrainAcceleration found{.value = train.by_force * pull + train.by_back_force * back.value +
                                   train.by_displacement * motion.q + train.by_velocity * motion.v,
                          .by_displacement = {},
                          .by_velocity = {}};
  if (!train.harmonics.empty()) found.value += train.ripple(mesh.path.mesh_periods(T)) * train.by_ripple;
  if (!derivatives) return found;
  found.by_displacement = train.by_displacement + back.slope * train.by_back_force * train.back;
  found.by_displacement.col(0) -= contacts.stiffness(forces) * train.by_force;
  found.by_velocity = train.by_velocity;
  found.by_velocity.col(0) -= damper * train.by_force;
  return found;
}

}  // namespace gearfilm

#include "dynamics/train_rates.hpp"

#include <numeric>

#include "mesh/reverse_flanks.hpp"

namespace gearfilm {

TrainAcceleration train_acceleration(const MeshModel& mesh, const LoadedContacts& loaded, double T,
                                     const Motion& motion, double damping, bool derivatives) {
  const MeshTrain& train = *mesh.train;
  const auto& [contacts, forces] = loaded;
  const ReverseForce back = reverse_flank_force(mesh, motion, T);
  const double damper = mesh.inertia * damping;
  const double pull = std::accumulate(forces.begin(), forces.end(), -mesh.scales.static_force) - damper * motion.V0();
  TrainAcceleration found{
      .value = train.acceleration(motion, pull, back.value, mesh.path, T), .by_displacement = {}, .by_velocity = {}};
  if (!derivatives) return found;
  found.by_displacement = train.by_displacement + back.slope * train.by_back_force * train.back;
  found.by_displacement.col(0) -= contacts.stiffness(forces) * train.by_force;
  found.by_velocity = train.by_velocity;
  found.by_velocity.col(0) -= damper * train.by_force;
  return found;
}

}  // namespace gearfilm

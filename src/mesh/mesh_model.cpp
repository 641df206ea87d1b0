#include "mesh/mesh_model.hpp"

#include <algorithm>
#include <cstdlib>

namespace gearfilm {

MeshedContact meshed_contact(const LineOfAction& line, const Scales& scales, double pinion_speed, double xi) {
  const double inside = std::clamp(xi, line.entry(), line.exit());
  const double u_m = scales.operation.entrainment_velocity;
  return {.position = xi,
          .conditions = {.relative_radius = line.radius_x(inside) / scales.solids.radius_x,
                         .entrainment = line.entrainment_velocity(inside, pinion_speed) / u_m,
                         .sliding = line.sliding_velocity(xi, pinion_speed) / u_m}};
}

SurfaceVelocities velocities_of(const Scales& scales, const MeshedContact& contact) {
  const double u_m = scales.operation.entrainment_velocity;
  return {.mean = u_m * contact.conditions.entrainment, .sliding = u_m * contact.conditions.sliding};
}

MeshedContact MeshModel::contact(int number, double T) const {
  MeshedContact contact = contact_at(number, path.position(number, T));
  const double speed = path.course().speed(T);
  contact.conditions.entrainment *= speed;
  contact.conditions.sliding *= speed;
  if (topography && path.held()) {
    const SurfaceVelocities velocities = velocities_of(scales, contact);
    contact.conditions.texture.place[0] += velocities.pinion() * scales.time * T;
    contact.conditions.texture.place[1] -= velocities.wheel() * scales.time * T;
  }
  return contact;
}

MeshedContact MeshModel::contact_at(int number, double xi) const {
  MeshedContact contact = meshed_contact(path.line(), scales, path.pinion_speed(), xi);
  contact.conditions.gap_offset = teeth.gap(number, xi) / scales.thickness;
  contact.conditions.local = teeth.local(xi);
  if (scales.solids.face) contact.conditions.beside_middle = teeth.beside_middle(xi);
  if (topography) contact.conditions.texture = {topography, path.line().involute_lengths(xi)};
  contact.conditions.nearest = nearest_point(scales, contact.conditions);
  return contact;
}

Compliance MeshModel::compliance(std::span<const int> numbers, double T) const {
  if (teeth.rigid()) return {};
  const auto films = static_cast<Eigen::Index>(numbers.size());
  return Compliance(Eigen::MatrixXd::NullaryExpr(films, films, [&](Eigen::Index row, Eigen::Index column) {
    const int k = numbers[row], j = numbers[column];
    const double c = k == j ? teeth.compliance(path.position(k, T)) : teeth.coupling(std::abs(k - j));
    return c * compliance_scale();
  }));
}

Motion MeshModel::in_train(const Motion& motion) const {
  if (motion.freedoms() == freedoms()) return motion;
  Motion whole = Motion::zero(freedoms());
  whole.H0() = motion.H0();
  whole.v = train->by_force * (motion.V0() / train->by_force[0]);
  return whole;
}

std::optional<LoadSharing::Piece> MeshModel::share_from(double T) const {
  if (!load) return {};
  return load->sharing.piece_at(path.position(0, T));
}

}  // namespace gearfilm

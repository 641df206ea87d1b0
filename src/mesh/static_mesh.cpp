#include "mesh/static_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

constexpr double carrying = 1e-3;  // of the load

StaticPosition balanced(const DryForce& force, const MeshModel& mesh, const std::vector<int>& numbers, double T,
                        double load) {
  const DryContacts contacts(force, mesh, numbers, T);
  StaticPosition position{T, numbers, contacts.balance(load), {}, 0.0};
  position.forces = contacts.forces(position.H0);
  position.stiffness = contacts.stiffness(position.forces);
  return position;
}

/// By which a contact that enters at the position's time, which it is not yet part of, meets its mate.
double penetration_met(const MeshModel& mesh, const StaticPosition& before, int entering) {
  std::vector<int> numbers = before.contacts;
  std::vector<double> forces = before.forces;
  numbers.push_back(entering);
  forces.push_back(0.0);
  const double displaced = mesh.compliance(numbers, before.T).displacements(before.H0, forces).back();
  return -displaced - mesh.contact(entering, before.T).conditions.dry_gap();
}

std::optional<double> met_at_entry(const DryForce& force, const MeshModel& mesh, double load) {
  const ContactPath& path = mesh.path;
  for (double begin = 0.0; begin < path.mesh_period() * (1.0 - 1e-9);) {
    const std::vector<int> numbers = path.contacts_after(begin);
    begin = path.next_event(begin);
    const int next = numbers.back() + 1;
    if (std::abs(path.entry_time(next) - begin) > 1e-6 * path.mesh_period()) continue;
    return penetration_met(mesh, balanced(force, mesh, numbers, begin, load), next);
  }
  return {};
}

}  // namespace

double pitch_stiffness(const Scales& scales, const LineOfAction& line, const Teeth& teeth) {
  constexpr double any_speed = 1.0;  // [rad/s]
  const MeshModel mesh{
      .scales = scales, .path = ContactPath(line, scales, any_speed, 0.0), .teeth = teeth.without_pitch_errors()};
  return balanced(DryForce(mesh), mesh, mesh.path.contacts_after(0.0), 0.0, scales.static_force).stiffness;
}

std::optional<double> entry_penetration(const MeshModel& mesh, double load) {
  return met_at_entry(DryForce(mesh), mesh, load);
}

double corner_distance(const MeshModel& mesh, double penetration) {
  const LineOfAction& line = mesh.path.line();
  const double tangent = line.radius_wheel(line.entry()) / line.base_radius_wheel();
  return std::sqrt(2.0 * line.radius_x(line.entry()) * penetration * mesh.scales.thickness) / tangent;
}

StaticMesh quasi_static_cycle(const MeshModel& mesh, double load, int positions) {
  const DryForce force(mesh);
  const ContactPath& path = mesh.path;
  const double period = path.mesh_period();
  StaticMesh result;
  std::array<double, 5> cosine{}, sine{};
  double largest = -HUGE_VAL, smallest = HUGE_VAL;
  for (double begin = 0.0; begin < period * (1.0 - 1e-9);) {
    const std::vector<int> numbers = path.contacts_after(begin);
    const double end = std::min(period, path.next_event(begin));
    const int steps = std::max(2, static_cast<int>(std::ceil(positions * (end - begin) / period)));
    for (int n = 0; n <= steps; ++n) {
      const StaticPosition here = balanced(force, mesh, numbers, begin + (end - begin) * n / steps, load);
      // Trapezoids between events.
      const double weight = (n == 0 || n == steps ? 0.5 : 1.0) * (end - begin) / steps / period;
      result.mean -= weight * here.H0;
      result.mean_stiffness += weight * here.stiffness;
      for (std::size_t k = 0; k < cosine.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k + 1) * here.T / period;
        cosine[k] += 2.0 * weight * here.H0 * std::cos(angle);
        sine[k] += 2.0 * weight * here.H0 * std::sin(angle);
      }
      const auto carry = [&](double F) { return F > carrying * load; };
      result.effective_contact_ratio += weight * static_cast<double>(std::ranges::count_if(here.forces, carry));
      largest = std::max(largest, here.H0);
      smallest = std::min(smallest, here.H0);
      result.positions.push_back(here);
    }
    begin = end;
  }
  result.entry_penetration = met_at_entry(force, mesh, load);
  result.peak_to_peak = largest - smallest;
  for (std::size_t k = 0; k < cosine.size(); ++k) result.harmonics[k] = std::hypot(cosine[k], sine[k]);
  double at_pitch = path.time_at(0.0);
  while (at_pitch < 0.0) at_pitch += period;
  result.at_pitch = balanced(force, mesh, path.contacts_after(at_pitch), at_pitch, load);
  return result;
}

}  // namespace gearfilm

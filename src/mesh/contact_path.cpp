#include "mesh/contact_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gearfilm {

ContactPath::ContactPath(const LineOfAction& line, const Scales& scales, double pinion_speed, double start,
                         MeshGeometry geometry, const SpeedCourse& course)
    : line_(line),
      geometry_(geometry),
      pinion_speed_(pinion_speed),
      velocity_(line.travel_velocity(pinion_speed) * scales.time),
      start_(start),
      course_(course) {
  if (geometry_ == MeshGeometry::single) return;
  // Number 0 is the leading contact; one at its exit has left.
  while (phase_at(line_.exit(), -1) > tolerance()) start_ += line_.base_pitch();
  while (phase_at(line_.exit(), 0) <= tolerance()) start_ -= line_.base_pitch();
}

std::vector<int> ContactPath::contacts_after_phase(double phase) const {
  const double just_after = phase + tolerance(), exit = phase_at(line_.exit(), 0);
  if (geometry_ == MeshGeometry::single) return exit > just_after ? std::vector<int>{0} : std::vector<int>{};
  // The leading contact is the first whose exit still lies ahead.
  int contact = static_cast<int>(std::floor((phase - exit) / mesh_period())) - 1;
  while (phase_at(line_.exit(), contact) <= just_after) ++contact;
  std::vector<int> contacts;
  for (; phase_at(line_.entry(), contact) <= just_after; ++contact) contacts.push_back(contact);
  return contacts;
}

double ContactPath::next_event(double T) const {
  if (geometry_ == MeshGeometry::held) return std::numeric_limits<double>::infinity();
  if (geometry_ == MeshGeometry::single) return exit_time(0);
  const std::vector<int> contacts = contacts_after(T);
  const int next = contacts.empty() ? 0 : contacts.back() + 1;
  const double leaving = contacts.empty() ? std::numeric_limits<double>::infinity() : exit_time(contacts.front());
  return std::min(leaving, entry_time(next));
}

double ContactPath::next_passage(double xi, double T) const {
  if (geometry_ == MeshGeometry::held) return std::numeric_limits<double>::infinity();
  const double first = phase_at(xi, 0), passed = (meshing_phase(T) + tolerance() - first) / mesh_period();
  return course_.time(first + (std::floor(passed) + 1.0) * mesh_period());
}

double ContactPath::last_event(double T) const {
  const std::vector<int> contacts = contacts_after(T);
  if (geometry_ != MeshGeometry::moving || contacts.empty()) return -std::numeric_limits<double>::infinity();
  return std::max(entry_time(contacts.back()), exit_time(contacts.front() - 1));
}

}  // namespace gearfilm

// Which tooth contacts exist at a dimensionless time T, and where.
//
// Contact n sits at xi_n(T) = xi_start + velocity phase(T) - n p_b while entry <= xi_n <= exit; contact 0 leads at T =
// 0, higher numbers follow. With held geometry the contacts stay where they are at T = 0, while their surfaces go on
// moving oil: the pair at one position, for its free oscillation. phase(T) is T at constant speed (speed_course.hpp).
// Any contact ratio >= 1. Source: section 2 of
// doi 10.1016/j.triboint.2013.01.017.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/scales.hpp"
#include "gear/line_of_action.hpp"
#include "mesh/speed_course.hpp"

namespace gearfilm {

/// single: one contact from its start to its exit, without others.
enum class MeshGeometry { moving, held, single };

class ContactPath {
public:
  /// pinion_speed [rad/s]; start: position of a contact at T = 0 [m] on the path of contact.
  ContactPath(const LineOfAction& line, const Scales& scales, double pinion_speed, double start,
              MeshGeometry geometry = MeshGeometry::moving, const SpeedCourse& course = {});

  /// xi of a contact [m].
  double position(int contact, double T) const {
    return start_ + velocity_ * meshing_phase(T) - contact * line_.base_pitch();
  }
  double entry_time(int contact) const { return course_.time(phase_at(line_.entry(), contact)); }
  double exit_time(int contact) const { return course_.time(phase_at(line_.exit(), contact)); }

  /// Contacts just after T, the leading one first. A contact at its exit has left, one at its entry is there.
  std::vector<int> contacts_after(double T) const { return contacts_after_phase(meshing_phase(T)); }
  /// Contacts just before T. A contact at its exit is still there, one at its entry not yet.
  std::vector<int> contacts_before(double T) const {
    return contacts_after_phase(meshing_phase(T) - 3.0 * tolerance());
  }
  /// The next time after T at which a contact enters or leaves; infinity where none does.
  double next_event(double T) const;
  /// The last time up to T at which one did; -infinity where none does.
  double last_event(double T) const;

  /// The next time after T at which a contact passes xi; infinity where the contacts stand.
  double next_passage(double xi, double T) const;

  /// Mesh period at the first speed [s].
  double mesh_period() const { return line_.base_pitch() / velocity_; }
  /// Mesh periods that have passed at T, and when so many have.
  double mesh_periods(double T) const { return course_.phase(T) / mesh_period(); }
  double time_after(double mesh_periods) const { return course_.time(mesh_periods * mesh_period()); }
  const SpeedCourse& course() const { return course_; }
  bool held() const { return geometry_ == MeshGeometry::held; }
  /// When contact 0 is at xi.
  double time_at(double xi) const { return course_.time((xi - start_) / velocity_); }
  /// Length travelled along the line of action [m].
  double distance(double T) const { return velocity_ * meshing_phase(T); }
  const LineOfAction& line() const { return line_; }
  double pinion_speed() const { return pinion_speed_; }  ///< the first [rad/s]
  /// The pinion's speed at T.
  double rpm(double T) const { return pinion_speed_ * course_.speed(T) * 30.0 / std::numbers::pi; }

private:
  /// Phases closer than this are one event.
  double tolerance() const { return 1e-9 * mesh_period(); }
  double meshing_phase(double T) const { return geometry_ == MeshGeometry::held ? 0.0 : course_.phase(T); }
  /// Phase in which a contact is at xi.
  double phase_at(double xi, int contact) const { return (xi + contact * line_.base_pitch() - start_) / velocity_; }
  std::vector<int> contacts_after_phase(double phase) const;

  LineOfAction line_;
  MeshGeometry geometry_;
  double pinion_speed_;
  double velocity_;  ///< d(xi)/d(phase) [m]
  double start_;
  SpeedCourse course_;
};

}  // namespace gearfilm

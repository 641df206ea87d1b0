// Which tooth contacts exist at a dimensionless time T, and where.
//
// Contact n sits at xi_n(T) = xi_start + velocity T - n p_b while entry <= xi_n <= exit; contact 0 leads at T = 0,
// higher numbers follow. With held geometry the contacts stay where they are at T = 0, while their surfaces go on
// moving oil: the pair at one position, for its free oscillation. Any contact ratio >= 1. Source: section 2 of
// doi 10.1016/j.triboint.2013.01.017.
#pragma once

#include <cmath>
#include <vector>

#include "gearfilm/contact/scales.hpp"
#include "gearfilm/gear/line_of_action.hpp"

namespace gearfilm {

/// single: one contact from its start to its exit, without others.
enum class MeshGeometry { moving, held, single };

class ContactPath {
public:
  /// pinion_speed [rad/s]; start: position of a contact at T = 0 [m] on the path of contact.
  ContactPath(const LineOfAction& line, const Scales& scales, double pinion_speed, double start,
              MeshGeometry geometry = MeshGeometry::moving);

  /// xi of a contact [m].
  double position(int contact, double T) const {
    return start_ + velocity_ * meshing_time(T) - contact * line_.base_pitch();
  }
  double entry_time(int contact) const { return (line_.entry() + contact * line_.base_pitch() - start_) / velocity_; }
  double exit_time(int contact) const { return (line_.exit() + contact * line_.base_pitch() - start_) / velocity_; }

  /// Contacts just after T, the leading one first. A contact at its exit has left, one at its entry is there.
  std::vector<int> contacts_after(double T) const;
  /// Those just before T: one at its exit is still there, one at its entry not yet.
  std::vector<int> contacts_before(double T) const { return contacts_after(T - 3.0 * tolerance()); }
  /// The next time after T at which a contact enters or leaves; infinity where none does.
  double next_event(double T) const;

  double mesh_period() const { return line_.base_pitch() / velocity_; }
  /// When contact 0 is at xi.
  double time_at(double xi) const { return (xi - start_) / velocity_; }
  /// Length travelled along the line of action [m].
  double distance(double T) const { return velocity_ * meshing_time(T); }
  const LineOfAction& line() const { return line_; }
  double pinion_speed() const { return pinion_speed_; }  ///< [rad/s]

private:
  /// Times closer than this are one event.
  double tolerance() const { return 1e-9 * mesh_period(); }
  double meshing_time(double T) const { return geometry_ == MeshGeometry::held ? 0.0 : T; }

  LineOfAction line_;
  MeshGeometry geometry_;
  double pinion_speed_;
  double velocity_;  ///< d(xi)/dT [m]
  double start_;
};

}  // namespace gearfilm

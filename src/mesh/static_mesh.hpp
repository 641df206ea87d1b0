// The dry pair turned slowly through one mesh period under a steady load: transmission error, load shares, stiffness.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/dry_force.hpp"

namespace gearfilm {

/// One position of the gears; the leading contact first.
struct StaticPosition {
  double T = 0.0;  ///< of the mesh model, within its first period
  std::vector<int> contacts;
  double H0 = 0.0;             ///< the transmission error is its negative [-]
  std::vector<double> forces;  ///< pressure integrals [-]
  double stiffness = 0.0;      ///< dF/d(-H_0) [-]
};

struct StaticMesh {
  /// From one leaving to the next; both sides of every entering, which are two positions at one T.
  std::vector<StaticPosition> positions;
  double mean = 0.0;                  ///< of -H_0 over the period [-]
  double peak_to_peak = 0.0;          ///< of H_0 [-]
  std::array<double, 5> harmonics{};  ///< amplitudes of H_0 at the first mesh frequencies [-]
  StaticPosition at_pitch;            ///< a contact at the pitch point
  double mean_stiffness = 0.0;        ///< [-]
  std::optional<double>
      entry_penetration;                 ///< by which an entering contact meets its mate at once [-]; negative: a gap
  double effective_contact_ratio = 0.0;  ///< contacts that carry, on the average
};

/// dF/d(-H_0) of the dry mesh where a contact is at the pitch point, under the static force: all contacts that there
/// are, bending included, without pitch errors [-]. Throws SolveError where nothing carries the load.
double pitch_stiffness(const Scales& scales, const LineOfAction& line, const Teeth& teeth);

/// By which an entering contact meets its mate at once under a load, both [-]; negative: a gap. Absent where contacts
/// enter as others leave.
std::optional<double> entry_penetration(const MeshModel& mesh, double load);
/// How far before the path of contact the wheel's tip edge would then meet the pinion's flank [m]: where its gap
/// x^2 tan^2(phi_a2)/(2 R_x) is less than the penetration [-] > 0.
double corner_distance(const MeshModel& mesh, double penetration);

/// The load [-], at so many positions. The mesh starts (T = 0) just after a contact has left. Throws SolveError where
/// nothing carries the load.
StaticMesh quasi_static_cycle(const MeshModel& mesh, double load, int positions);

}  // namespace gearfilm

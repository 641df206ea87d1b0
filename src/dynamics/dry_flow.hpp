// The motion of the dry pair over its mesh periods, with its derivatives by where it began and by a parameter.
//
//   x = (H_0, V_0) ,   x' = f(x, s; lambda) = T_m (V_0, (F(H_0, s T_m) - F*)/I_n - c V_0) ,   s = T/T_m
//   Phi' = (df/dx) Phi , Phi(0) = 1 ;   w' = (df/dx) w + df/dlambda , w(0) = 0
// A pair in a drive train has x = (y, dy/dT), the relative displacements of all its parts, dimensionless, and their
// velocities; accelerations are those of train_rates.hpp.
// T_m: mesh period. Events are at the same s whatever the parameter, and leave the motion as it is, so that Phi and w
// need no jumps there. df/dlambda is a difference of f alone: without the noise that one between two motions would
// have.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/step_record.hpp"
#include "mesh/dry_force.hpp"

namespace gearfilm {

/// c of a damping ratio zeta, which relates to the linear natural frequency f_n.
inline double dry_damping(const MeshModel& mesh, double zeta) {
  return 4.0 * std::numbers::pi * zeta * mesh.frequency();
}

/// What the contacts pass through in a mesh period.
struct DryExtremes {
  double largest_force = 0.0;   ///< on one contact [-]
  double smallest_force = 0.0;  ///< of all contacts together [-]
  double least_approach = 0.0;  ///< of the contact that is pressed most, F_k = 0 at 0 [-]; negative: all are apart
};

/// After every mesh period, and in it.
struct DryPeriod {
  Motion motion;
  DryExtremes extremes;
};

struct DryFlowEnd {
  std::vector<Motion> states;  ///< after every mesh period
  Eigen::MatrixXd by_start;    ///< derivative of the last one by the first motion
  Motion by_parameter;         ///< the same by the parameter, times its unit
  DryExtremes extremes;
};

class DryFlowRun;

class DryFlow {
public:
  /// A pair and the same pair at a parameter that is greater by a part of its unit. damping_ratio: dry_damping() of it
  /// is c.
  DryFlow(const MeshModel& mesh, const MeshModel& beside, double part, double damping_ratio);

  /// A pair without a parameter, by which the derivative is zero.
  DryFlow(const MeshModel& mesh, double damping_ratio);
  /// A pair for between() alone, in time itself; damping: c.
  static DryFlow in_time(const MeshModel& mesh, double damping);
  /// The motion at a time from that at another. No call depends on those before. Throws SolveError where it is not
  /// finite, as do the others.
  Motion between(const Motion& start, double T_begin, double T_end) const;
  /// Follows the motion from T = 0 on.
  DryFlowEnd operator()(const Motion& start, int mesh_periods) const;

  /// Follows the motion without derivatives, which would grow beyond bounds in a long march. The observer may throw.
  static void march(const MeshModel& mesh, double damping_ratio, const Motion& start, int mesh_periods,
                    const std::function<void(const DryPeriod&)>& observer);

private:
  friend class DryFlowRun;

  struct Pair {
    Pair(const MeshModel& of, double c, double unit) : mesh(of), force(of), damping(c), period(unit) {}

    MeshModel mesh;
    DryForce force;
    double damping;  ///< c
    double period;   ///< T_m, or 1 for a motion that knows no periods
  };

  DryFlow(Pair here, std::optional<Pair> beside, double part);

  Pair here_;
  std::optional<Pair> beside_;
  double part_;
  bool same_contacts_;                           ///< of both pairs: the parameter leaves them alone
  mutable std::shared_ptr<DryFlowRun> steps_{};  ///< with which between() integrates
};

}  // namespace gearfilm

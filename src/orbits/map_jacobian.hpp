// Newton's method on a map x -> P(x) of motions whose Jacobian is known approximately, and becomes better by Broyden's
// update after every evaluation.
//
// Source: C. G. Broyden, A class of methods for solving nonlinear simultaneous equations, Math. Comp. 19 (1965),
// 577-593.
#pragma once

#include "orbits/monodromy.hpp"

namespace gearfilm {

class MapJacobian {
public:
  /// The Jacobian of a map of motions with so many degrees of freedom [-], in whose norm velocities are multiplied by
  /// velocity_worth; an empty monodromy stands for zero.
  MapJacobian(Eigen::Index freedoms, double velocity_worth, Monodromy monodromy);

  const Monodromy& monodromy() const { return entries_; }
  /// The step by which P(x) - x, the defect, would vanish, shortened so that H_0, and V_0 by its worth, change by no
  /// more than `largest`, or than P itself changes them: what else a drive train does is nearly linear.
  Motion newton_step(const Motion& defect, double largest) const;
  /// The map changed by map_change over a step of its argument: the smallest change of the Jacobian that agrees, where
  /// velocities count by their worth.
  void update(const Motion& step, const Motion& map_change);

private:
  double worth_;
  Monodromy entries_;
};

}  // namespace gearfilm

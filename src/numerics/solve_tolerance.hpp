// How far each linear system of Newton's method is solved.
//
// A change that solves a system to a relative eta leaves eta |r| of the residual, and with it what the rows' curvature
// brings, c |r|, whatever eta is. Solving to much less than c is lost, and solving to more than is needed where c is
// small costs a further iteration, with a new linearisation and a Krylov space begun anew. Near a solution c falls with
// the residual, so one iteration tells the next:
//
//   c_k = c_{k-1} |r_k| / |r_{k-1}| ,   c_{k-1} |r_{k-1}| = (|r_k|^2 - |linear residual of k-1|^2)^(1/2)
//
// and the first iteration of a solve (a time step) tells that of the next one.
#pragma once

#include <optional>

namespace gearfilm {

/// Relative tolerances of linear solves [-].
struct SolveBounds {
  double loosest;  ///< also the tolerance where nothing is known yet
  double tightest;
};

class SolveTolerance {
public:
  explicit SolveTolerance(SolveBounds bounds) : bounds_(bounds) {}

  /// Of the system of an iteration, 0, 1, ..., whose residual has this norm. `linear` is the norm that the last linear
  /// solve left, `aim` that at which Newton's method ends.
  double next(int iteration, double norm, double linear, double aim);

private:
  SolveBounds bounds_;
  std::optional<double> first_{};  ///< c/|r| of the first iteration of a solve, once there was one
  double before_ = 0.0;            ///< norm of the iteration before
};

}  // namespace gearfilm

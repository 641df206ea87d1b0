// Points of a branch: periodic motions (q, v) of a map that depends on one parameter.
//
//   P(x, lambda) = x ,   x = (q, v) where a period begins          2 n + 1 coordinates u = (q, v, lambda/unit)
//   tangent t:  (DP - I) t_x + P_lambda t_lambda = 0 ,  |t| = 1: orthogonal to the 2 n rows
// and the pseudo-arclength corrector: Newton's method for P(x, lambda) = x on the plane normal . (u - predicted) = 0.
// Source: H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977).
#pragma once

#include <functional>
#include <optional>

#include "dynamics/step_record.hpp"
#include "orbits/monodromy.hpp"

namespace gearfilm {

struct BranchState {
  Motion motion;
  double parameter = 0.0;  ///< lambda, in its own unit
};

/// The map over one period of the branch, and what is seen on the way.
struct MapValue {
  std::vector<Motion> states;   ///< after each of the parts of which the branch's order says how many there are
  Monodromy by_motion;          ///< DP
  Motion by_parameter;          ///< P_lambda, by one unit of the parameter
  double largest_force = 0.0;   ///< on one contact, over the static force
  double smallest_force = 0.0;  ///< of all contacts together, over the static force
  /// Positive where there is always contact, negative where it is lost: smooth through zero.
  double least_approach = 1.0;
  /// Where the map has approximate derivatives: replaces them by measured ones, once this is known to be a periodic
  /// motion.
  std::function<void(MapValue&)> measure{};

  const Motion& image() const { return states.back(); }
};

/// The map of a given order (how many parts it consists of). Derivatives may be approximate: they say how fast Newton's
/// method converges, and the multipliers. Throws SolveError where there is no value.
using BranchMap = std::function<MapValue(const BranchState& at, int order)>;

/// A vector in u.
using BranchVector = Eigen::VectorXd;

struct BranchPoint {
  BranchState state;
  MapValue value;
  BranchVector tangent;  ///< towards where the branch goes on

  Multipliers multipliers() const { return gearfilm::multipliers(value.by_motion); }
  bool stable() const { return largest_modulus(multipliers()) < 1.0; }
};

struct CorrectorOptions {
  double unit = 1.0;        ///< change of the parameter that counts as much as 1 of q and v
  double tolerance = 1e-9;  ///< on |P(x) - x|, its largest part, for each part of the period
  int most_iterations = 10;
};

class BranchCorrector {
public:
  BranchCorrector(BranchMap map, int order, const CorrectorOptions& options)
      : map_(std::move(map)), order_(order), options_(options) {}

  int order() const { return order_; }
  double unit() const { return options_.unit; }
  BranchVector coordinates(const BranchState& state) const {
    BranchVector u(2 * state.motion.freedoms() + 1);
    u << to_vector(state.motion), state.parameter / options_.unit;
    return u;
  }
  BranchState state(const BranchVector& u) const {
    return {to_motion(u.head(u.size() - 1)), options_.unit * u[u.size() - 1]};
  }

  struct Corrected {
    BranchPoint point;
    int iterations = 0;
  };
  /// The periodic motion on the plane through the predicted state. Its tangent makes an acute angle with the normal.
  /// Nothing where Newton's method does not converge.
  std::optional<Corrected> correct(const BranchVector& predicted, const BranchVector& normal) const;
  /// Corrects at the parameter of the guess.
  std::optional<Corrected> at_parameter(const BranchState& guess) const;

private:
  /// Derivatives and tangent of a point that is found; false where it has none.
  bool finish(BranchPoint& point, const BranchVector& normal) const;

  BranchMap map_;
  int order_;
  CorrectorOptions options_;
};

}  // namespace gearfilm

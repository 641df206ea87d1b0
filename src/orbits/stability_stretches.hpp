// Where branches of periodic motions are stable: each branch cut where its stability changes and where it turns round.
#pragma once

#include <optional>
#include <vector>

#include "orbits/continuation.hpp"

namespace gearfilm {

/// A part of a branch between two such places.
struct Stretch {
  int branch = 0;
  int order = 0;
  double from = 0.0, to = 0.0;  ///< values of the parameter
  bool stable = false;
};

class StabilityStretches {
public:
  /// Adds the next point, in the order in which points are found.
  void add(const Branch& branch, PointKind kind, const BranchPoint& point);
  const std::vector<Stretch>& all() const { return stretches_; }

private:
  std::vector<Stretch> stretches_;
  std::optional<double> boundary_;  ///< parameter of the bifurcation since the last regular point
  bool turned_ = false;             ///< that was a fold
};

}  // namespace gearfilm

// What a continuation says of its branches: a line for each bifurcation on the screen, at the end the stretches on
// which they are stable and those on which they are not, and all of it for the summary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "orbits/continuation.hpp"
#include "output/progress.hpp"
#include "output/summary.hpp"

namespace gearfilm {

class BranchReport {
public:
  /// unit: of the parameter; every_point: prints a line for each, where they take long; otherwise a line says now and
  /// then how far the branch is.
  BranchReport(MPI_Comm comm, std::string unit, bool every_point)
      : comm_(comm), unit_(std::move(unit)), every_point_(every_point), progress_(comm) {}

  /// A point, in the order in which they are found. at: what else the summary says of a bifurcation there.
  void add(const Branch& branch, PointKind kind, const BranchPoint& point, const Summary& at);
  /// Prints the stretches, and warns of branches that were lost.
  void finish(const std::vector<Branch>& branches);

  /// How many there were.
  int points() const { return points_; }
  /// Lists `bifurcations` and `stretches`.
  Summary summary() const;
  static Summary branch_summary(const Branch& branch);

private:
  /// Of a branch between two changes of its stability or direction.
  struct Stretch {
    int branch = 0;
    int order = 0;
    double from = 0.0, to = 0.0;  ///< values of the parameter
    bool stable = false;
  };

  void extend(const Branch& branch, const BranchPoint& point);
  void print(const Branch& branch, PointKind kind, const BranchPoint& point);

  MPI_Comm comm_;
  std::string unit_;
  int points_ = 0;
  bool every_point_;
  LongWork progress_;
  Summary bifurcations_ = Summary::array();
  std::vector<Stretch> stretches_;
  std::optional<double> boundary_;  ///< where something has happened since the last regular point
  bool turned_ = false;             ///< that was a fold
};

}  // namespace gearfilm

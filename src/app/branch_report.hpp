// Prints the progress of a continuation: a line for each bifurcation, and at the end the stretches on which the
// branches are stable or unstable.
#pragma once

#include <string>
#include <vector>

#include "orbits/stability_stretches.hpp"
#include "output/progress.hpp"

namespace gearfilm {

class BranchReport {
public:
  /// unit: of the parameter; every_point: prints a line for each, where they take long; otherwise a line says now and
  /// then how far the branch is.
  BranchReport(MPI_Comm comm, std::string unit, bool every_point)
      : comm_(comm), unit_(std::move(unit)), every_point_(every_point), progress_(comm) {}

  /// A point, in the order in which they are found.
  void add(const Branch& branch, PointKind kind, const BranchPoint& point);
  /// Prints the stretches, and warns of branches that were lost.
  void finish(const std::vector<Branch>& branches, const std::vector<Stretch>& stretches);

private:
  void print(const Branch& branch, PointKind kind, const BranchPoint& point);

  MPI_Comm comm_;
  std::string unit_;
  bool every_point_;
  LongWork progress_;
};

}  // namespace gearfilm

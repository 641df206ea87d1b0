// What a continuation leaves: the table /continuation, written as its points are found, and its summary: bifurcations,
// branches, and the stretches on which these are stable.
#pragma once

#include <optional>

#include "input/case.hpp"
#include "orbits/stability_stretches.hpp"
#include "output/results_file.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

class ContinuationResult {
public:
  /// The case must outlive it. Collective, as are the others.
  ContinuationResult(MPI_Comm comm, const CaseInput& problem);

  void add(const Branch& branch, PointKind kind, const BranchPoint& point);
  /// Closes the table and writes the summary of what was found. mesh_periods: marched for it on films, or null;
  /// completed: all that was asked for.
  void write(const std::vector<Branch>& branches, const double* mesh_periods, bool completed);

  const StabilityStretches& stretches() const { return stretches_; }

private:
  MPI_Comm comm_;
  const CaseInput& problem_;
  ResultsFile file_;
  std::optional<ResultsTable> table_;
  int points_ = 0;
  Summary bifurcations_ = Summary::array();
  StabilityStretches stretches_;
};

std::string continuation_markdown();

}  // namespace gearfilm

// The table of a continuation's points in results.h5, written as they are found.
#pragma once

#include <optional>

#include "input/case.hpp"
#include "orbits/continuation.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

class ContinuationTable {
public:
  /// The case must outlive it. Collective, as are the others.
  ContinuationTable(MPI_Comm comm, const CaseInput& problem);

  /// Returns what of the point is in the summary.
  Summary add(const Branch& branch, PointKind kind, const BranchPoint& point);
  void finish();

private:
  const CaseInput& problem_;
  ResultsFile file_;
  std::optional<ResultsTable> table_;
};

}  // namespace gearfilm

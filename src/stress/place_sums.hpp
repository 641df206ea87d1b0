// Sums at some places, to which all processes contribute, on the processes that keep the places.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

namespace gearfilm {

/// `contributed`: of all places, `size` numbers each. `sums`: of the places that this process keeps, ranges[rank] to
/// ranges[rank + 1]. Collective.
inline void distribute_sums(MPI_Comm comm, std::span<const int> ranges, std::size_t size,
                            std::span<const double> contributed, std::span<double> sums) {
  std::vector<int> counts;
  for (std::size_t rank = 0; rank + 1 < ranges.size(); ++rank) {
    counts.push_back((ranges[rank + 1] - ranges[rank]) * static_cast<int>(size));
  }
  MPI_Reduce_scatter(contributed.data(), sums.data(), counts.data(), MPI_DOUBLE, MPI_SUM, comm);
}

}  // namespace gearfilm

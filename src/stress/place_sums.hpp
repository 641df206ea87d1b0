// Sums at some places, to which all processes contribute, on the processes that keep the places; and what all of them
// keep, on the first one.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

#include "stress/equivalent_stress.hpp"

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

/// Stresses at all places on the first process, elsewhere nothing. `own`: at those that this process keeps, `size`
/// each. Collective.
inline std::vector<Stress> gather_stresses(MPI_Comm comm, std::span<const int> ranges, std::size_t size,
                                           std::span<const Stress> own) {
  constexpr std::size_t components = stress_components;
  std::vector<int> counts, offsets;
  for (std::size_t rank = 0; rank + 1 < ranges.size(); ++rank) {
    offsets.push_back(static_cast<int>(ranges[rank] * size * components));
    counts.push_back(static_cast<int>((ranges[rank + 1] - ranges[rank]) * size * components));
  }
  std::vector<double> values, all(ranges.back() * size * components);
  for (const Stress& stress : own) {
    const auto of_place = stress.components();
    values.insert(values.end(), of_place.begin(), of_place.end());
  }
  MPI_Gatherv(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, all.data(), counts.data(), offsets.data(),
              MPI_DOUBLE, 0, comm);
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::vector<Stress> stresses;
  for (std::size_t n = 0; rank == 0 && n < all.size(); n += components) {
    stresses.push_back({all[n], all[n + 1], all[n + 2], all[n + 3], all[n + 4], all[n + 5]});
  }
  return stresses;
}

}  // namespace gearfilm

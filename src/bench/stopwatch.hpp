// Timing of repeated work.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <vector>

namespace gearfilm {

/// Median time [s] of one call of `work`, over at least `least_runs` calls and about `budget` seconds, after one call
/// to warm up. Collective work must be timed with fixed_runs, so that all processes repeat it equally often.
template <class Work>
double median_time(Work&& work, double budget = 0.3, int least_runs = 7, int fixed_runs = 0) {
  work();
  std::vector<double> times;
  double total = 0.0;
  const auto more = [&] {
    const int runs = static_cast<int>(times.size());
    return fixed_runs > 0 ? runs < fixed_runs : runs < least_runs || (total < budget && runs < 2000);
  };
  while (more()) {
    const double start = MPI_Wtime();
    work();
    times.push_back(MPI_Wtime() - start);
    total += times.back();
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

}  // namespace gearfilm

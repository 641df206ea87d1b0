// Speed of the kernels and of stationary films on one grid, in seconds, per node, and in convolution times
// (convolution_time.hpp).
#pragma once

#include "bench/bench_pair.hpp"

namespace gearfilm {

/// Measures and prints, on the case's grid. Collective.
Summary bench_grid(MPI_Comm comm, const CaseInput& problem);

}  // namespace gearfilm

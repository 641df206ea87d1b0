// Speed of the lubricated pair: a contact-step, a whole periodic job, and what several processes make of them.
#pragma once

#include "gearfilm/input/case.hpp"
#include "gearfilm/traction/traction_model.hpp"
#include "output/summary.hpp"

namespace gearfilm {

struct GridSize {
  int nx, ny;
};

/// A convolution's time as the first process has it now; on a shared machine it changes. Collective.
double common_unit(MPI_Comm comm, GridSize size);

/// A film that feels its heat, in the case's own oil or one that thins as oils do.
TractionModel warm_film(const Case& problem);

/// Measures and prints, on 129 x 65 nodes; several processes on 257 x 257 too. Collective.
Summary bench_pair(MPI_Comm comm, const Case& problem);

}  // namespace gearfilm

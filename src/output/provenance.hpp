// What computed a result: this program's version and those of its libraries, and the number of processes.
#pragma once

#include <mpi.h>

#include "output/summary.hpp"

namespace gearfilm {

/// Keys: version, processes, and petsc, slepc, mpi, hdf5, fftw with the versions of the libraries that run.
Summary provenance(MPI_Comm comm);

}  // namespace gearfilm

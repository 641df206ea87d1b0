// Memory that a grid needs, and what the machines have.
#pragma once

#include <mpi.h>

namespace gearfilm {

/// Throws InputError, on all processes alike, for a grid that cannot fit, for so many contacts at a time with so many
/// points across films that feel their heat, into the memory of the machines on which the processes run. Collective.
void require_memory(MPI_Comm comm, int nx, int ny, int contacts, int heated_points);

}  // namespace gearfilm

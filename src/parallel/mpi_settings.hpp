// Settings of Open MPI that gearfilm wants.
#pragma once

namespace gearfilm {

/// Puts into the environment what Open MPI, by the version of the library that runs, does not choose well by itself,
/// except where the user has chosen. To be called before MPI starts. Other implementations are left alone.
void prefer_mpi_settings();

}  // namespace gearfilm

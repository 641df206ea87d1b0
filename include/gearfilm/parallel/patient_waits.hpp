// Processes that wait for others without keeping a core from them.
//
// Open MPI polls while it waits. Where all processes have cores of their own, that is the fastest; where a core is
// shared, the process that is waited for may be the one that does not run, for a time slice of milliseconds at every
// exchange. Told to yield, Open MPI calls sched_yield() in every round of polling. Here that function returns at once
// while a wait is as short as those between processes that all run; in a longer one it sleeps, a sixteenth of what has
// been waited so far.
#pragma once

namespace gearfilm {

/// To be called before MPI starts. Other implementations of MPI, and a user who says so
/// (OMPI_MCA_mpi_yield_when_idle=0), are left alone.
void wait_patiently();

}  // namespace gearfilm

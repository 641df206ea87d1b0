// Processes that wait for others without keeping a core from them.
//
// Open MPI polls while it waits. Where all processes have cores of their own, that is the fastest; where other programs
// run on these cores too, the process that is waited for may be the one that does not run, for a time slice of
// milliseconds at every exchange. Told to yield, Open MPI calls sched_yield() in every round of polling, which on Linux
// gives a whole time slice to whoever else is there. Here that function can do nothing while a wait is as short as
// those between processes that all run, and sleep in a longer one, a sixteenth of what has been waited so far. That
// serves processes each of which has a core; those that share one among them must yield to each other.
#pragma once

namespace gearfilm {

/// Whether Open MPI's mpiexec has bound this process, as it does where there is a core for each: then it may use fewer
/// than mpiexec itself, which has at least one for every process here. False on other systems than Linux.
bool has_own_core();

/// What sched_yield() does from now on; without effect on other systems than Linux.
void sleep_in_long_waits(bool yes);

}  // namespace gearfilm

// The commands of the program. Each takes a checked case, prints its main results and writes them to the case's
// output folder.
#pragma once

#include "input/case.hpp"

namespace gearfilm {

/// Derived quantities only, no field solve.
void run_info(MPI_Comm comm, const CaseInput& problem);
/// Stationary film at one position.
void run_steady(MPI_Comm comm, const CaseInput& problem);
/// The dry pair turned slowly through one mesh period.
void run_static(MPI_Comm comm, const CaseInput& problem);
/// The gear pair marched in time.
void run_transient(MPI_Comm comm, const CaseInput& given);
/// The periodic state of the lubricated pair.
void run_periodic(MPI_Comm comm, const CaseInput& given);
/// Natural frequencies of the dry pair and of the pair on its films.
void run_eigen(MPI_Comm comm, const CaseInput& given);
/// Periodic states over a range of speeds, torques or masses.
void run_sweep(MPI_Comm comm, const CaseInput& problem);
/// Flanks that wear over many revolutions.
void run_wear(MPI_Comm comm, const CaseInput& given);
/// Branches of periodic states in speed, torque or mass.
void run_continuation(MPI_Comm comm, const CaseInput& problem);
/// The standard set of speed measurements.
void run_bench(MPI_Comm comm, const CaseInput& problem);

}  // namespace gearfilm

// Warnings at the end of a run: results outside the model's validity, or that physics left out would change.
#pragma once

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Where the film of an isothermal run is far too thick, since shear heats its inlet: by Murch and Wilson's factor in a
/// summary. Says nothing where the case asks for isothermal films itself (`thermal.model: none`).
void warn_of_heating(MPI_Comm comm, const CaseInput& problem, const Summary& heating);

/// Where a summary, of one contact or of a march, has pressures that hardened steel does not bear or under which the
/// gears yield, temperatures beyond those of the oil's laws, or that did not settle, and films thinner than the flanks
/// are rough.
void warn_of_validity(MPI_Comm comm, const CaseInput& problem, const Summary& summary);

/// Relative error up to which nothing is said of it: 5 %, or more where the case itself says so by grid.accuracy.
double tolerable_error(const CaseInput& problem);

/// Says that the bar of the largest pressure is that of a spike, where it is.
void note_spike(MPI_Comm comm, const Summary& summary);

}  // namespace gearfilm

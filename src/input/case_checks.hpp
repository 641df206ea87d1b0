// Loads of a case that leave the model's validity: strains that are not small, teeth that bend out of mesh.
#pragma once

#include "input/case.hpp"

namespace gearfilm {

/// Throws InputError where the Hertz pressure of the reference load is above a tenth of the reduced modulus.
void check_strain(const CaseInput& problem);

/// Throws InputError where another load that the case names makes such a pressure: of `steady`, of `static`, of the
/// displacement at the start; or where the static force bends the teeth by a module.
void check_loads(const CaseInput& problem);

}  // namespace gearfilm

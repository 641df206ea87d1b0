// FGMRES (Saad 1993, doi 10.1137/0914028) that keeps its basis in single precision where that serves, in half the
// memory: a type of PETSc's KSP.
//
// With directions z_j, the preconditioned v_j, rounded before they are multiplied, A z_j = sum_i h_ij v_i holds but for
// the rounding of the v_i. A restart begins with the residual of the solution so far, in double precision; so does a
// cycle that has gained what its precision can tell. Vectors are made as iterations need them.
#pragma once

#include <functional>

#include "parallel/petsc.hpp"

namespace gearfilm {

/// For a KSP with an operator and a preconditioner; restart: iterations of a cycle. single_serves: whether products of
/// the present operator bear the round-off of single precision; the same on all processes.
void use_compact_fgmres(KSP ksp, int restart, std::function<bool()> single_serves);

}  // namespace gearfilm

// FGMRES (Saad 1993, doi 10.1137/0914028) whose basis is kept in single precision, in half the memory: a type of
// PETSc's KSP for linear systems that need few digits.
//
// With directions z_j, the preconditioned v_j, rounded before they are multiplied, A z_j = sum_i h_ij v_i holds but for
// the rounding of the v_i. A restart begins with the residual of the solution so far, in double precision; so does a
// cycle that has gained what single precision can tell. Vectors are made as iterations need them.
#pragma once

#include "parallel/petsc.hpp"

namespace gearfilm {

/// For a KSP with an operator and a preconditioner; restart: iterations of a cycle.
void use_compact_fgmres(KSP ksp, int restart);

}  // namespace gearfilm

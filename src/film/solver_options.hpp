// Choices that change how a film is solved for, not what it is.
#pragma once

#include "numerics/newton.hpp"

namespace gearfilm {

/// Arithmetic of the linearised film: its products and its preconditioner. Residuals and Krylov vectors are always
/// double, so that single costs no digit of a solution; where it would cost convergence double is taken.
enum class Precision { single_precision, double_precision };

/// What the smoother's factors are of: the state of the linearisation, or an earlier one of the same march, as long as
/// they serve (row_smoother.hpp).
enum class SmootherFactors { of_this_state, of_earlier_states_too };

/// Options of the preconditioner of one contact's film.
struct MultigridOptions {
  int levels = 0;            ///< 0 = chosen by the grid; 1 = the smoother alone
  bool keep_rows = true;     ///< where cells are long: levels are coarser along X alone
  int smoothing_sweeps = 1;  ///< before and after each coarse-grid correction
  int coarse_sweeps = 4;     ///< on the coarsest level
  Precision precision = Precision::single_precision;
};

/// Options of the solver of a stationary film.
struct SolverOptions {
  NewtonOptions newton;
  MultigridOptions multigrid;
};

}  // namespace gearfilm

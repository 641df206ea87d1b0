// Choices that change how a film is solved for, not what it is.
#pragma once

namespace gearfilm {

/// Arithmetic of the multigrid preconditioner; residuals and the Krylov space are always double.
enum class Precision { single_precision, double_precision };

struct SolverOptions {
  double newton_tolerance = 1e-8;    ///< on the root mean square of the scaled residual [-]
  int newton_max_iterations = 60;    ///< per grid and pseudo-time step
  double krylov_tolerance = 0.05;    ///< relative, of each linear solve [-]
  int krylov_max_iterations = 200;   ///< per Newton step
  int levels = 0;                    ///< multigrid levels of the preconditioner; 0 = chosen by the grid
  int smoothing_sweeps = 1;          ///< before and after each coarse-grid correction
  int coarse_sweeps = 4;             ///< on the coarsest level
  Precision precision = Precision::single_precision;
};

}  // namespace gearfilm

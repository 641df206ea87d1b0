// Newton's method as all film problems use it: SNES with a shell Jacobian, FGMRES (compact_fgmres.hpp), and a shell
// preconditioner.
//
// Globalised by backtracking on the merit of the residual, along which no pressure becomes negative: in thick film the
// row of such a node is d P with a huge d, and one of them would shorten the whole step. In a time step the first guess
// is near, except at the few nodes which the edge of the contact crosses: there the conductance varies exponentially
// with pressure (the Table 3 oil has alpha_B p_h = 63), Newton overshoots, and a backtracking that shortens the whole
// step for their sake crawls. Where a full step leads up, single nodes that have overshot therefore take a part of
// their changes only (overshoot.hpp); that may lead to three times what it was before, since their neighbours have not
// followed yet. Each node's change can also be limited by itself first: no pressure falls by more than 0.4 of it, or
// rises by more than the system allows, in one step; and the system may adapt changes around pressures that would fall
// below zero. A direction so limited is not Newton's, and need not lead down at once: the merit may grow tenfold in an
// iteration, and the norm to a thousand times what it began with. A good first guess has a small norm, and it is behind
// such a one that a limit of ten stopped iterations which find their way.
#pragma once

#include <cmath>

#include "parallel/petsc.hpp"
#include "parallel/watcher.hpp"

namespace gearfilm {

struct NewtonOptions {
  double tolerance = 1e-8;  ///< on norm/weight: a root mean square of the scaled residual [-]
  int max_iterations = 60;
  /// Relative, of each linear solve [-]; no solve goes on where half of the tolerance above is left.
  double krylov_tolerance = 0.01;
  /// The same where one more iteration may be saved by solving further (solve_tolerance.hpp).
  double tightest_krylov_tolerance = 1.0;
  int krylov_max_iterations = 200;
  int unsolved = 1000;         ///< linear systems that may be left above the tolerance before the iteration is given up
  bool limit_changes = false;  ///< limit each node's change; for time steps, whose first guess is near
  Watcher watcher{};           ///< of stationary films, called every iteration
};

/// How much a pressure may change in an iteration at most.
struct PressureLimits {
  double rise = HUGE_VAL;
  double fall = 1.0;  ///< relative
};

/// A nonlinear system as its linear solver sees it, linearised about the last state.
class LinearisedSystem {
public:
  virtual ~LinearisedSystem() = default;
  virtual MPI_Comm comm() const = 0;
  virtual PetscInt local_size() const = 0;
  /// How many entries of the local array, from its beginning, are pressures.
  virtual PetscInt pressure_count() const = 0;
  /// Where changes are limited.
  virtual PressureLimits pressure_limits() const { return {}; }
  /// Improves a change that would leave pressures below zero, which then become zero.
  virtual void project_change(Vec /*state*/, Vec /*change*/) {}
  /// How far rows are from zero, as a line search compares it: their norm, where nothing else is better.
  virtual double merit(Vec rows);
  /// Shortens single entries of a change of which a full step has overshot, given the rows before and after it; false
  /// where there are none. `whole` is the change as it was before any call. The system's last state is that after it.
  virtual bool relax_overshot_nodes(Vec /*change*/, Vec /*whole*/, Vec /*before*/, Vec /*after*/) { return false; }
  /// How far the state that was evaluated last is from that of the Jacobian, over the longest way that one step may go;
  /// 0 where steps may be of any length.
  virtual double moved() { return 0.0; }
  /// `to` is a copy of the state `from`: what the system knows of the one holds for the other.
  virtual void copied(Vec /*from*/, Vec /*to*/) {}
  /// Whether its products and its preconditioner are computed in single precision.
  virtual bool in_single_precision() const { return false; }
  virtual void multiply(Vec change, Vec rows) = 0;
  virtual void precondition(Vec rows, Vec change) = 0;
};

/// The Jacobian of a system.
OwnedMat shell_jacobian(LinearisedSystem& system);

/// FGMRES on the system's Jacobian with the system's preconditioner.
void configure_krylov(KSP ksp, LinearisedSystem& system, double tolerance, int max_iterations);

/// Newton, Krylov and preconditioner settings of a SNES whose functions are set; weight turns norms into root mean
/// squares. The system must outlive the SNES.
void configure_newton(SNES snes, LinearisedSystem& system, const NewtonOptions& options, double weight);

/// Another norm of the residual at which to end, for a SNES that is configured.
void aim_at(SNES snes, double norm);

/// How many iterations it may take, for a SNES that is configured.
void allow_iterations(SNES snes, int most);

/// Whether the residual may grow on the way.
enum class Growth { none, tenfold };

/// For a SNES that is configured.
void allow_growth(SNES snes, LinearisedSystem& system, Growth growth);

/// Whether changes of nodes are limited by the system's limits.
enum class Changes { free, limited };

/// For a SNES that is configured; limited ones let the residual grow tenfold on the way, free ones do not.
void limit_changes(SNES snes, LinearisedSystem& system, Changes changes);

}  // namespace gearfilm
